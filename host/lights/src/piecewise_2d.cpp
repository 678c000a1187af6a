// Piecewise-constant density over the unit square.
#include "piecewise_2d.h"

#include <algorithm>

#include "warp.h"

namespace lxs {
namespace {

std::size_t cell(float x, std::size_t n) {
    if (!(x > 0)) return 0;
    return std::min(static_cast<std::size_t>(x * static_cast<float>(n)), n - 1);
}

/// In [0, 1]: never in the next of n cells, whose density may be another.
float place(std::size_t cell, float share, std::size_t n) {
    const auto low = static_cast<float>(cell);
    return within_interval(low, low + 1, share) / static_cast<float>(n);
}

/// Where in cell number `cell` of n the place `x` is.
float share(float x, std::size_t cell, std::size_t n) {
    return std::clamp(x * static_cast<float>(n) - static_cast<float>(cell), 0.0f, 1.0f);
}

}  // namespace

Vec2 Piecewise2D::sample(const Vec2& u, float& density) const {
    const DrawnCell drawn = cells_.draw(u);
    density = drawn.probability * count();
    return Vec2(place(drawn.column, drawn.share.x, cells_.width()),
                place(drawn.row, drawn.share.y, cells_.height()));
}

float Piecewise2D::density(const Vec2& p) const {
    if (!positive()) return 0;
    return cells_.probability(cell(p.y, cells_.height()), cell(p.x, cells_.width())) * count();
}

bool Piecewise2D::coordinates(const Vec2& p, Vec2& u) const {
    if (!positive()) return false;
    const std::size_t row = cell(p.y, cells_.height()), column = cell(p.x, cells_.width());
    return cells_.coordinates(
        row, column, Vec2(share(p.x, column, cells_.width()), share(p.y, row, cells_.height())), u);
}

}  // namespace lxs
