// Pixels of a denoised image that a filter's lobes had made dark.
#pragma once

#include <span>

#include "negative_lobes.h"

namespace lxs {

/// Where `image` is far darker, and `denoised` dimmer, than a denoised pixel within the filter's
/// reach, `denoised` is made no brighter than `image` is there, of its own colour: beside what is
/// bright, the negative lobes of the filter make rings that no other pixel is like, so that a mean
/// with others fills them. Where denoising has removed the bright pixel, it removes the ring as
/// well. Both are of one size and at least 0; the same bits for any number of threads.
void keep_dark_beside_bright(const FilteredImage& denoised, std::span<const Rgb> image);

}  // namespace lxs
