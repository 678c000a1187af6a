// The radii within which visible points search for photons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace aips {

/// Radii of one pass, scene units: one for all visible points, or one for each.
struct GatherRadii {
    GatherRadii() = default;
    /// The same radius for all.
    GatherRadii(float radius) : largest(radius), mean(radius) {}

    float of(std::size_t visible_point) const {
        return per_point.empty() ? largest : per_point[visible_point];
    }

    /// One for each, kept elsewhere; at least one.
    explicit GatherRadii(std::span<const float> radii);

    /// Beyond it from all visible points no photon matters.
    float reach() const { return std::max(largest, probe_radius); }

    float largest = 0;  ///< grids are built for it
    float mean = 0;
    std::span<const float> per_point;       ///< empty if all are the same
    std::span<const std::uint32_t> probes;  ///< visible points around which light is probed
    float probe_radius = 0;                 ///< of all probes
};

}  // namespace aips
