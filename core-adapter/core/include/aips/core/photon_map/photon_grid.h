// Range queries over photons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/unwritten.h"
#include "aips/core/photon_map/cell_sort.h"
#include "aips/core/photon_map/photon.h"
#include "aips/core/photon_map/reach_filter.h"

namespace aips {

/// What density estimation needs of a photon: compact, and in the order in which queries read.
struct GridPhoton {
    Vec3 position;
    Vec3 direction;  ///< unit, back to where the photon came from
    Rgb power;       ///< watts, not divided by the number of photon paths
    Vec3 normal;     ///< unit geometric normal of the surface, of the side the photon came from
    std::uint16_t light_group = 0;
    std::uint16_t shareable : 1 = 0;    ///< Photon::shareable
    std::uint16_t part : 2 = 0;         ///< Photon::part
    std::uint16_t bounces : 10 = 0;     ///< Photon::bounces
    std::uint16_t found_alone : 1 = 0;  ///< Photon::found_alone
    std::uint32_t index = 0;            ///< number of the photon among those that were sorted
};

/// The photon with number `index`, with its normal turned to the photon's side.
inline GridPhoton grid_photon(const Photon& l, std::uint32_t index) {
    const Vec3 normal = dot(l.direction, l.normal) > 0 ? l.normal : -l.normal;
    return {l.position,
            l.direction,
            l.power,
            normal,
            l.light_group,
            l.shareable,
            l.part,
            std::uint16_t(l.bounces),
            std::uint16_t(l.found_alone),
            index};
}

/// Photons as a CellSort has them. Buffers are reused; queries are const and may run on many
/// threads.
class PhotonGrid {
  public:
    /// Sorts copies of `photons` (fewer than 2^32) for searches up to `radius`. Photons at
    /// positions that are not finite are left out. The result is the same for every `parallel`.
    /// Where many more `queries` follow than there are photons, it pays to know at once where
    /// there is nothing.
    void build(std::span<const Photon> photons, float radius,
               const ParallelFor& parallel = serial_for, std::size_t queries = 0);

    /// Calls `visit(const GridPhoton&)` once for each photon with |position - p| <= radius, in an
    /// order that is a function of the photons alone. `radius` beyond radius() is cut to it.
    template <class F>
    void for_each_in_radius(Vec3 p, float radius, F&& visit) const {
        if (!is_finite(p) || !filter_.may_reach(p)) return;
        cells_.for_each_in_radius(p, radius, [&](std::uint32_t slot) { visit(photons_[slot]); });
    }

    /// Photons that queries can find.
    std::size_t size() const { return cells_.size(); }
    /// Greatest radius of a query.
    float radius() const { return cells_.radius(); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() when no build ever has more than `max_photons`.
    static std::size_t memory_bound_bytes(std::size_t max_photons);

  private:
    CellSort cells_;
    ReachFilter filter_;                   // where photons are few
    UnwrittenVector<Vec3> positions_;      // [photon], for the sort
    UnwrittenVector<GridPhoton> photons_;  // [slot]
};

}  // namespace aips
