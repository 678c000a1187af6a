// Layers that are parts of the image.
#include "sum_to_image.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace lxs {
namespace {

constexpr int kMostRounds = 100;
constexpr double kTolerated = 1e-6;    ///< of a part's mean, relative
constexpr double kRounding = 0x1p-21;  ///< of a pixel that needs no scaling, likewise

/// Of each part, over all pixels.
std::vector<Imath::V3d> totals(std::span<const ColorLayer> parts) {
    std::vector<Imath::V3d> sums(parts.size(), Imath::V3d(0.0));
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
        for (const Rgb& value : parts[p].values)
            sums[p] += Imath::V3d(value);
    });
    return sums;
}

/// Scales the parts of each pixel so that they sum to the image.
void scale_pixels(std::span<ColorLayer> parts, std::span<const Rgb> image) {
    tbb::parallel_for(std::size_t{0}, image.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) {
            double sum = 0;
            for (const ColorLayer& part : parts)
                sum += double{part.values[i][c]};
            const double factor = double{image[i][c]} / sum;
            if (std::abs(factor - 1) < kRounding) continue;
            for (ColorLayer& part : parts) {
                float& value = part.values[i][c];
                // Where all are black, alike.
                value = std::isfinite(factor) ? static_cast<float>(double{value} * factor)
                                              : image[i][c] / static_cast<float>(parts.size());
            }
        }
    });
}

/// Scales each part so that it has its total; false if they have.
bool scale_parts(std::span<ColorLayer> parts, std::span<const Imath::V3d> wanted) {
    const std::vector<Imath::V3d> found = totals(parts);
    bool scaled = false;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Imath::V3f factor(1.0f);
        bool fits = true;
        for (int c = 0; c < 3; ++c) {
            const double ratio = wanted[p][c] / found[p][c];
            if (!std::isfinite(ratio) || std::abs(ratio - 1) < kTolerated) continue;
            factor[c] = static_cast<float>(ratio);
            fits = false;
        }
        if (fits) continue;
        scaled = true;
        for (Rgb& value : parts[p].values)
            value *= Rgb(factor.x, factor.y, factor.z);
    }
    return scaled;
}

}  // namespace

void sum_to_image(std::span<ColorLayer> parts, std::span<const Rgb> image) {
    if (parts.empty()) return;
    const std::vector<Imath::V3d> wanted = totals(parts);
    for (int round = 0; round < kMostRounds; ++round) {
        scale_pixels(parts, image);
        if (!scale_parts(parts, wanted)) return;
    }
    scale_pixels(parts, image);
}

}  // namespace lxs
