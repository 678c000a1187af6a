// Axis-aligned boxes.
#pragma once

#include <limits>

#include "aips/core/base/vector.h"

namespace aips {

/// Closed axis-aligned box; empty when `lower > upper` in any axis, as a new one is.
struct Bounds {
    static constexpr float kInf = std::numeric_limits<float>::infinity();
    Vec3 lower{kInf, kInf, kInf};
    Vec3 upper{-kInf, -kInf, -kInf};

    void extend(Vec3 p) {
        lower = min(lower, p);
        upper = max(upper, p);
    }
    void extend(const Bounds& b) {
        lower = min(lower, b.lower);
        upper = max(upper, b.upper);
    }
    bool empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
    bool contains(Vec3 p) const {
        return p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x <= upper.x &&
               p.y <= upper.y && p.z <= upper.z;
    }
    Vec3 extent() const { return empty() ? Vec3{} : upper - lower; }
    Vec3 center() const { return (lower + upper) * 0.5f; }
    /// Length of the box's diagonal, 0 when empty.
    float diagonal() const { return length(extent()); }
    /// Axis (0, 1, 2) of the greatest extent; the lowest axis wins a tie.
    int longest_axis() const {
        const Vec3 e = extent();
        if (e.x >= e.y && e.x >= e.z) return 0;
        return e.y >= e.z ? 1 : 2;
    }
};

}  // namespace aips
