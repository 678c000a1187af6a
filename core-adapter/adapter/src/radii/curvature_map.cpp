// Sums of probes by pixel.
#include "radii/curvature_map.h"

#include <algorithm>
#include <cstdlib>

#include "base/film_pixel.h"

namespace aips {
namespace {

/// Half width of the windows of the widest discs' probes, pixels: each narrower disc has one less,
/// and the narrowest its own pixel alone.
constexpr int kWindow = int(kProbeScales) - 1;

}  // namespace

CurvatureMap::CurvatureMap(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), sums_(std::size_t{width} * height) {}

std::uint32_t CurvatureMap::pixel(Vec2 position) const {
    return film_pixel(position, width_, height_);
}

void CurvatureMap::add(std::uint32_t pixel, const ProbeEstimate& estimate) {
    Sums& sums = sums_[pixel];
    sums.probes += 1;
    sums.second_moment += estimate.second_moment;
    for (std::size_t scale = 0; scale < kProbeScales; ++scale) {
        sums.laplacian[scale] += estimate.laplacian[scale].value;
        sums.error2[scale] += estimate.laplacian[scale].error2;
    }
}

ProbeEstimate CurvatureMap::mean(std::uint32_t pixel) const {
    const int x = int(pixel % width_), y = int(pixel / width_);
    const int left = std::max(x - kWindow, 0), right = std::min(x + kWindow, int(width_) - 1);
    const int top = std::max(y - kWindow, 0), bottom = std::min(y + kWindow, int(height_) - 1);
    ProbeEstimate mean;
    std::array<double, kProbeScales> probes{};
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const Sums& sums = sums_[std::size_t(row) * width_ + std::size_t(column)];
            const int distance = std::max(std::abs(row - y), std::abs(column - x));
            const std::size_t scales = std::min(std::size_t(kWindow - distance) + 1, kProbeScales);
            mean.second_moment += sums.second_moment;
            for (std::size_t scale = 0; scale < scales; ++scale) {
                probes[scale] += sums.probes;
                mean.laplacian[scale].value += sums.laplacian[scale];
                mean.laplacian[scale].error2 += sums.error2[scale];
            }
        }
    }
    mean.second_moment /= std::max(probes[0], 1.0);
    for (std::size_t scale = 0; scale < kProbeScales; ++scale) {
        const double count = std::max(probes[scale], 1.0);
        mean.laplacian[scale].value /= count;
        mean.laplacian[scale].error2 /= count * count;
    }
    return mean;
}

// Any numbers will do: where radii don't follow from them the schedule's are taken.
void CurvatureMap::state(StateArchive& archive) {
    for (Sums& sums : sums_) {
        archive.value(sums.probes);
        archive.value(sums.second_moment);
        for (std::size_t scale = 0; scale < kProbeScales; ++scale) {
            archive.value(sums.laplacian[scale]);
            archive.value(sums.error2[scale]);
        }
    }
}

}  // namespace aips
