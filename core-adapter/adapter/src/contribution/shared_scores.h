// Scores of photons where each rank has Bsdfs of its own visible points alone.
#pragma once

#include <functional>
#include <span>

#include "contribution/photon_score.h"

namespace aips {

/// Fills `scores` with those of photon(0), photon(1), ..., the same on all ranks. Points with a
/// Bsdf are asked by the rank that has it, of all photons; then each rank sums the scores of its
/// share of the photons, in the order that one process alone would sum them in.
void score_with_ranks(const PhotonScore& score, const PointOwners& owners,
                      const std::function<const Photon&(std::size_t)>& photon,
                      std::span<double> scores);

}  // namespace aips
