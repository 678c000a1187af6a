// The pixel of a film position, and the square of pixels that it learns with.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "aips/core/base/vector.h"
#include "base/constants.h"

namespace aips {

/// Number, row by row, of the pixel of a width x height film that `position` (pixels) is in; beyond
/// the film's edge the nearest one. NaN: the first of its row or column.
inline std::uint32_t film_pixel(Vec2 position, std::uint32_t width, std::uint32_t height) {
    const auto index = [](float x, std::uint32_t size) {
        return x > 0 ? static_cast<std::uint32_t>(std::min(x, float(size - 1))) : 0;
    };
    return index(position.y, height) * width + index(position.x, width);
}

/// Squares of kFilmCell x kFilmCell pixels that lie side by side along so many.
constexpr std::uint32_t film_cells_along(std::uint32_t pixels) {
    return (pixels + kFilmCell - 1) / kFilmCell;
}

/// Number, row by row, of the square that pixel number `pixel` of a film of this width is in.
constexpr std::size_t film_cell(std::uint32_t pixel, std::uint32_t width) {
    return std::size_t{pixel / width / kFilmCell} * film_cells_along(width) +
           pixel % width / kFilmCell;
}

}  // namespace aips
