// Images as planes of one number a pixel, and means over squares of pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs::denoising {

struct Size {
    std::uint32_t width, height;
    std::size_t pixels() const { return std::size_t{width} * height; }
};

using Plane = std::vector<float>;  ///< [pixel], row by row
using Colors = std::array<Plane, 3>;

/// Numbers that are not finite become zero.
Colors planes_of(std::span<const Rgb> image);
Plane finite(std::span<const float> values);

/// Mean over the 3 x 3 pixels around each, fewer at the image's edges.
Plane mean_around(const Plane& plane, Size size);

}  // namespace lxs::denoising
