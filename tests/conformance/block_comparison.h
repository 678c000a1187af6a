// How far an image is from its reference: relative differences of block means.
#pragma once

#include <array>
#include <cstddef>

#include "rendered_image.h"

namespace conformance {

/// Side of a block, pixels. Pixels beyond the last whole block are left out.
inline constexpr std::size_t kBlock = 10;

/// Spread of relative differences over the blocks, 0.02 being 2 %.
struct Spread {
    double median = 0;
    double p95 = 0;  ///< 95th percentile, linear between the nearest ranks
};

/// Both figures below the limit's.
inline bool is_below(const Spread& found, const Spread& limit) {
    return found.median < limit.median && found.p95 < limit.p95;
}

/// An image against its reference.
struct Comparison {
    Spread luminance;
    std::array<Spread, 3> channels;      ///< red, green, blue
    std::array<double, 3> mean_ratio{};  ///< mean of the image over the reference's, by channel
};

/// |a / b - 1| over the blocks, a's luminance against b's. A block that is black in b counts by
/// its difference over a millionth of b's mean, so that light in it can't pass unseen. Throws
/// std::invalid_argument if the images differ in size or are smaller than a block.
Comparison compare(const render::Image& a, const render::Image& b);

/// Noise of the mean of two independent renders of equally many samples, in the same measure:
/// |a - b| / (a + b) spreads as the mean's relative error does.
Spread noise_of_mean(const render::Image& a, const render::Image& b);

/// Pixel by pixel mean. Throws std::invalid_argument if the sizes differ.
render::Image mean(const render::Image& a, const render::Image& b);

/// Numbers of the image that are below zero, or no number at all.
std::size_t negatives(const render::Image& image);
std::size_t not_finite(const render::Image& image);

}  // namespace conformance
