// The pixel of a film position.
#pragma once

#include <algorithm>
#include <cstdint>

#include "aips/core/base/vector.h"

namespace aips {

/// Number, row by row, of the pixel of a width x height film that `position` (pixels) is in; beyond
/// the film's edge the nearest one. NaN: the first of its row or column.
inline std::uint32_t film_pixel(Vec2 position, std::uint32_t width, std::uint32_t height) {
    const auto index = [](float x, std::uint32_t size) {
        return x > 0 ? static_cast<std::uint32_t>(std::min(x, float(size - 1))) : 0;
    };
    return index(position.y, height) * width + index(position.x, width);
}

}  // namespace aips
