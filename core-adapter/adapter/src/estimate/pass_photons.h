// How many photon paths a pass shoots, and what they count for.
#pragma once

#include <cstdint>

namespace aips {

/// Photons that wait for a gather, stored or in media; one iteration may exceed it.
inline constexpr std::size_t kWaitingPhotons = 1u << 20;

/// The photon paths of one pass, known before it.
struct PassPhotons {
    std::uint64_t before = 0;  ///< photon paths of all passes before
    std::uint32_t paths = 0;   ///< of this pass
    double counted = 0;        ///< paths, those that are shot while a guide learns as they weigh
    double weight = 1;         ///< of the pass in the photons' part of the image
    /// Photon paths of the passes before the last choice, which rests on what they brought: numbers
    /// that are stratified over passes begin anew there. 0 if there was none.
    std::uint64_t chosen_at = 0;
    /// Photon paths of earlier renders whose knowledge a guide began with: as if they were of this.
    std::uint64_t known = 0;
    /// Of so many photons in media each beam takes one, which counts for all; a power of two.
    std::uint32_t thinning = 1;
};

}  // namespace aips
