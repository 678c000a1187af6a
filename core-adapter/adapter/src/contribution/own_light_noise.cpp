// Noise of what eye paths bring by themselves.
#include "contribution/own_light_noise.h"

#include <algorithm>
#include <utility>

#include "base/assign_all.h"
#include "base/disjoint_ranges.h"
#include "base/film_pixel.h"
#include "base/ordered_sum.h"
#include "estimate/group_sums.h"

namespace aips {

OwnLightNoise::OwnLightNoise(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), pixels_(std::size_t{width} * height) {}

void OwnLightNoise::add_pass(const EyeImage& image, const PixelImportance& importance,
                             bool compare) {
    sum_pixels(image);
    in_chunks(pixels_.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Pixel &now = now_[i], &before = pixels_[i];
            now.squares = before.squares;
            if (compare && now.paths > 0 && before.paths > 0) {
                const double difference = now.sum / now.paths - before.sum / before.paths;
                now.squares +=
                    float(double(importance.weight_of_sharing(i)) * difference * difference / 2);
            }
            before = now;
        }
    });
    compared_ += compare;
}

void OwnLightNoise::sum_pixels(const EyeImage& image) {
    assign_all(now_, pixels_.size(), Pixel{});
    const auto pixel_of = [&](std::size_t path) {
        return film_pixel(image.positions[path], width_, height_);
    };
    in_disjoint_ranges(image.positions.size(), pixel_of, [&](std::size_t first, std::size_t last) {
        for (std::size_t path = first; path < last; ++path) {
            Pixel& pixel = now_[pixel_of(path)];
            pixel.sum += double(luminance_over_groups(image.radiance, path, image.groups));
            ++pixel.paths;
        }
    });
}

double OwnLightNoise::take() {
    if (compared_ == 0) return 0;
    const auto passes = double(std::exchange(compared_, 0));
    const double sum =
        ordered_sum<double>(pixels_.size(), [&](std::size_t first, std::size_t last) {
            double part = 0;
            for (std::size_t i = first; i < last; ++i) {
                const auto squares = double(std::exchange(pixels_[i].squares, 0.0f));
                part += std::min(squares / passes, kMostOfOwnLight);
            }
            return part;
        });
    return sum / double(pixels_.size());
}

// Whatever is restored, it gives an estimate of noise at worst that is none.
void OwnLightNoise::state(StateArchive& archive) {
    for (Pixel& pixel : pixels_) {
        archive.value(pixel.sum);
        archive.value(pixel.paths);
        archive.value(pixel.squares);
    }
    archive.value(compared_);
}

std::size_t OwnLightNoise::memory_bytes() const {
    return (pixels_.capacity() + now_.capacity()) * sizeof(Pixel);
}

std::size_t OwnLightNoise::memory_bound_bytes(std::size_t pixels) {
    return pixels * 2 * sizeof(Pixel);
}

}  // namespace aips
