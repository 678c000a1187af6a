// Random points in space, one a cell of the integer lattice (Worley 1996, "A Cellular Texture Basis
// Function"), and random numbers by cell.
#pragma once

#include <array>
#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs::shading {

/// How far points are from each other.
enum class DistanceMetric : std::uint8_t {
    Actual,
    Squared,
    Manhattan,
    Chebychev,
    MinkowskiHalf,
    MinkowskiFour,
    Minkowski
};

/// Distances from `p` to the four nearest points, rising; zeros where `p` isn't finite. `exponent`
/// is that of DistanceMetric::Minkowski.
std::array<float, 4> nearest_points(const Vec3& p, DistanceMetric metric, float exponent);

/// A number in [0, 1) for the cell that `p` lies in.
float cell_value(const Vec3& p);

}  // namespace lxs::shading
