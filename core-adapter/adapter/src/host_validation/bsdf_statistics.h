// What the samples of one material tell of its Bsdfs.
#pragma once

#include <array>

#include "direction_proposal.h"
#include "findings.h"
#include "octant_estimates.h"

namespace aips {

/// One choice of lobes, asked for at all places of a material.
struct DensityStatistics {
    LobeMask mask = 0;
    /// The same integrals over all directions and over octants, by samples of the Bsdf and by
    /// directions of a known density: DensityStatistics's owner says which.
    OctantEstimates by_samples, by_density;
};

struct BsdfStatistics {
    CheckStatistics values, directions, masks, lobes, deltas, pdfs, weights, unreachable, albedos,
        lambert, choices;
    std::vector<DensityStatistics> densities;
    LobeMask claimed = 0;               ///< by lobes(), at some place
    LobeMask drawn = 0;                 ///< by samples
    std::array<double, 3> albedo_of{};  ///< [lobe bit]: largest
    std::array<bool, 3> dark_albedo{};  ///< [lobe bit]: black at some place that scatters so
    double most_energy = 0;             ///< reflected and transmitted at a place, lower bound
};

/// One place of a material, where it is met along -wo.
struct BsdfPlace {
    const Bsdf& bsdf;
    Vec3 wo, geometric_normal, shading_normal;
    std::uint32_t samples;
};

/// Asks the place's Bsdf.
void ask_bsdf(const BsdfPlace& place, RandomStream& random, BsdfStatistics& statistics);

}  // namespace aips
