// Pixels below zero, settled with the light around them.
#pragma once

#include <cstdint>
#include <span>

#include "lxs/sdk/types.h"

namespace lxs {

/// An image whose pixels the negative lobes of a filter may have drawn below zero.
struct FilteredImage {
    std::span<Rgb> pixels;  ///< width * height, row by row; finite
    std::uint32_t width, height;
    std::uint32_t reach_x, reach_y;  ///< of the filter, pixels
};

/// Raises what is below zero to zero, each channel on its own, at the cost of the light around it:
/// what a bright pixel's neighbours lack through the filter's negative lobes, its middle has too
/// much of, so that cutting alone would brighten the image (by a sixth where single photons lie
/// apart under "mitchell"). A pixel takes from those within the filter's reach, in proportion to
/// what they have; where several ask for more than there is, each gets its share, and asks again,
/// at last twice as far away. Sums over neighbourhoods stay. What finds no
/// light around it becomes zero all the same. Costs next to nothing where nothing is negative; the
/// same bits for any number of threads.
void redistribute_negative_lobes(const FilteredImage& image);

}  // namespace lxs
