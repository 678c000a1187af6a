// Barycentric weights in double precision.
#include "triangle_weights.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

using Imath::V3d;

/// How many times as large as its ray a triangle is when its weights no longer do. Both errors are
/// of the order of 2^-24; below it the kernel's weights cost nothing.
constexpr double kLarge = 16;
/// How far beyond an edge a hit may be, in weights: more than any rounding of the kernel's.
constexpr double kBeyondEdge = 1e-5;

bool is_large(const CornerAndEdges& triangle, const V3d& origin, const V3d& direction,
              double distance) {
    const double size2 = std::max(triangle.e1.length2(), triangle.e2.length2());
    const double ray2 = origin.length2() + distance * distance * direction.length2();
    return size2 > kLarge * kLarge * ray2;
}

}  // namespace

void refine_weights(const CornerAndEdges& triangle, const V3d& origin, const V3d& direction,
                    RawHit& raw) {
    const bool none = raw.u == 0 && raw.v == 0;
    if (!none && !is_large(triangle, origin, direction, static_cast<double>(raw.distance))) return;
    // Moeller and Trumbore 1997: volumes of the direction, an edge and the origin's place over that
    // of the direction and both edges.
    const V3d side = direction.cross(triangle.e2), to = origin - triangle.corner;
    const double volume = triangle.e1.dot(side);
    if (volume == 0) return;
    // Not pressed into the triangle: the kernel knows large ones' edges no better than its weights.
    const auto near_triangle = [](double w) {
        return std::clamp(w, -kBeyondEdge, 1 + kBeyondEdge);
    };
    raw.u = near_triangle(to.dot(side) / volume);
    raw.v = near_triangle(direction.dot(to.cross(triangle.e1)) / volume);
}

}  // namespace lxs
