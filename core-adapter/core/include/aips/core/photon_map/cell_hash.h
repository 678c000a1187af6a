// Cells of an unbounded uniform grid, and their hash.
#pragma once

#include <algorithm>
#include <cstdint>

#include "aips/core/base/vector.h"

namespace aips {

/// Integer coordinates of a cell.
struct Cell {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const Cell&) const = default;
};

/// The cells [lower, upper] per axis that a ball touches.
struct CellRange {
    Cell lower, upper;
};

/// Maps points to the cells of a grid, in double precision and with floor: cells at zero are as
/// wide as others, and single-precision points keep their order.
class CellGrid {
  public:
    /// Cells two radii wide, so that balls of that radius touch two cells an axis (three, by
    /// rounding, where coordinates exceed 2^40 cells). `radius` is clamped to [1e-38, 1e38], NaN
    /// to the lower end.
    explicit CellGrid(float radius = 1)
        : radius_(radius > kMinRadius ? std::min(radius, kMaxRadius) : kMinRadius),
          inverse_width_(1.0 / (2.0 * kPadding * double(radius_))) {}

    /// The radius, clamped.
    float radius() const { return radius_; }
    /// Cell of a finite point.
    Cell cell(Vec3 p) const { return {coordinate(p.x), coordinate(p.y), coordinate(p.z)}; }
    /// Cells of every float point q with |q - p| <= radius, be that computed in single precision.
    /// p finite; `radius` in [0, radius()].
    CellRange cells_of_ball(Vec3 p, float radius) const {
        const double r = double(radius) * kPadding;
        return {{coordinate(p.x - r), coordinate(p.y - r), coordinate(p.z - r)},
                {coordinate(p.x + r), coordinate(p.y + r), coordinate(p.z + r)}};
    }
    /// A coordinate in units of cells, clamped to where cells can still be told apart.
    double scaled(double coordinate) const {
        return std::clamp(coordinate * inverse_width_, -kMaxCoordinate, kMaxCoordinate);
    }
    /// A radius in units of cells, with the margin of cells_of_ball().
    double scaled_radius(float radius) const { return double(radius) * kPadding * inverse_width_; }

  private:
    static constexpr float kMinRadius = 1e-38f;
    static constexpr float kMaxRadius = 1e38f;
    // Rounding in |q - p| <= radius is below one part in a million.
    static constexpr double kPadding = 1 + 1e-6;
    // Beyond this the cells of one axis merge: still correct, only slower.
    static constexpr double kMaxCoordinate = 0x1p50;

    std::int64_t coordinate(double value) const {
        const double s = scaled(value);
        const auto truncated = static_cast<std::int64_t>(s);
        return truncated - (s < double(truncated) ? 1 : 0);
    }

    float radius_;
    double inverse_width_;
};

/// 64 well-mixed bits of a cell (finaliser of SplitMix64, Steele et al. 2014).
inline std::uint64_t hash_cell(Cell c) {
    std::uint64_t h = std::uint64_t(c.x) * 0x9E3779B97F4A7C15u +
                      std::uint64_t(c.y) * 0xC2B2AE3D27D4EB4Fu +
                      std::uint64_t(c.z) * 0x165667B19E3779F9u;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
}

}  // namespace aips
