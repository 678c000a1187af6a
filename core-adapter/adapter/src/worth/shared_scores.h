// Scores of landings where each rank has Bsdfs of its own visible points alone.
#pragma once

#include <functional>
#include <span>

#include "worth/landing_score.h"

namespace aips {

/// Fills `scores` with those of landing(0), landing(1), ..., the same on all ranks. Points with a
/// Bsdf are asked by the rank that has it, of all landings; then each rank sums the scores of its
/// share of the landings, in the order that one process alone would sum them in.
void score_with_ranks(const LandingScore& score, const PointOwners& owners,
                      const std::function<const Landing&(std::size_t)>& landing,
                      std::span<double> scores);

}  // namespace aips
