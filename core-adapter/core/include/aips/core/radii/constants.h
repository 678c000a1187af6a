// Tuned constants of radii that adapt: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>

namespace aips {

/// A probe measures curvature in discs of this many radii, each half of the one before. Unit:
/// discs.
/// Balances: curvature of light that is small against memory and noise.
/// Chosen by: measurement.
/// Supported by: glass-ball, room, chess.
inline constexpr std::size_t kProbeScales = 3;

}  // namespace aips
