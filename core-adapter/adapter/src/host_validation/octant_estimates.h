// Estimates over all directions, and over each octant of them.
#pragma once

#include <array>

#include "aips/core/sampling/sampling.h"
#include "estimate.h"

namespace aips {

inline constexpr int kOctants = 8;

/// Which of eight octants around a frame a direction lies in.
inline int octant(const Frame& frame, Vec3 direction) {
    const Vec3 local = frame.to_local(direction);
    return (local.x > 0 ? 1 : 0) + (local.y > 0 ? 2 : 0) + (local.z > 0 ? 4 : 0);
}

/// The first is of all directions.
using OctantEstimates = std::array<Estimate, 1 + kOctants>;

/// Adds a sample in an octant; in none if that is negative.
inline void add(OctantEstimates& estimates, int octant, double value) {
    estimates[0].add(value);
    for (int i = 0; i < kOctants; ++i)
        estimates[1 + static_cast<std::size_t>(i)].add(i == octant ? value : 0);
}

}  // namespace aips
