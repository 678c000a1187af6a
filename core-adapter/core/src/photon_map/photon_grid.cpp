// Copies of photons in the order of their cells.
#include "aips/core/photon_map/photon_grid.h"

namespace aips {
namespace {

/// Queries for each photon from which on the filter is asked first.
constexpr std::size_t kQueriesOfFewPhotons = 8;

constexpr std::size_t kChunk = std::size_t(1) << 12;

}  // namespace

void PhotonGrid::build(std::span<const Photon> photons, float radius, const ParallelFor& parallel,
                       std::size_t queries) {
    // Nothing is kept of those before, which growing would move.
    positions_.clear();
    photons_.clear();
    positions_.reserve(rounded_capacity(photons.size()));
    photons_.reserve(rounded_capacity(photons.size()));
    positions_.resize(photons.size());
    in_chunks(photons.size(), kChunk, parallel, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            positions_[i] = photons[i].position;
    });
    cells_.build(positions_, radius, parallel);
    if (photons.size() * kQueriesOfFewPhotons < queries) {
        filter_.build(positions_, radius, parallel);
    } else {
        filter_.clear();
    }
    photons_.resize(cells_.size());
    in_chunks(cells_.size(), kChunk, parallel, [&](std::size_t first, std::size_t last) {
        for (std::size_t slot = first; slot < last; ++slot) {
            const std::uint32_t i = cells_.order()[slot];
            photons_[slot] = grid_photon(photons[i], i);
        }
    });
}

std::size_t PhotonGrid::memory_bytes() const {
    return cells_.memory_bytes() + filter_.memory_bytes() + positions_.capacity() * sizeof(Vec3) +
           photons_.capacity() * sizeof(GridPhoton);
}

std::size_t PhotonGrid::memory_bound_bytes(std::size_t max_photons) {
    return CellSort::memory_bound_bytes(max_photons) +
           ReachFilter::memory_bound_bytes(max_photons) +
           rounded_capacity(max_photons) * (sizeof(Vec3) + sizeof(GridPhoton));
}

}  // namespace aips
