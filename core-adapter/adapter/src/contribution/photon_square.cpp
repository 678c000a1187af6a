// Sums over passes of what photons bring.
#include "contribution/photon_square.h"

#include <utility>

#include "base/disjoint_ranges.h"
#include "base/film_pixel.h"
#include "base/ordered_sum.h"
#include "estimate/group_sums.h"

namespace aips {

PhotonSquare::PhotonSquare(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), pixels_(std::size_t{width} * height) {}

void PhotonSquare::add_pass(const EyeImage& image, std::span<const Rgb> photons) {
    const auto pixel_of = [&](std::size_t path) {
        return film_pixel(image.positions[path], width_, height_);
    };
    const double share = double(pixels_.size()) / double(image.positions.size());
    in_disjoint_ranges(image.positions.size(), pixel_of, [&](std::size_t first, std::size_t last) {
        for (std::size_t path = first; path < last; ++path)
            pixels_[pixel_of(path)] +=
                float(share * double(luminance_over_groups(photons, path, image.groups)));
    });
    ++passes_;
}

double PhotonSquare::take(const PixelImportance& importance) {
    if (passes_ == 0) return 0;
    const auto passes = double(std::exchange(passes_, 0));
    const auto sum_of = [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const double mean = double(std::exchange(pixels_[i], 0.0f)) / passes;
            sum += double(importance.weight_of_sharing(i)) * mean * mean;
        }
        return sum;
    };
    return ordered_sum<double>(pixels_.size(), sum_of) / double(pixels_.size());
}

// Whatever is restored, it tells of photons at worst that there are not.
void PhotonSquare::state(StateArchive& archive) {
    for (float& pixel : pixels_)
        archive.value(pixel);
    archive.value(passes_);
}

}  // namespace aips
