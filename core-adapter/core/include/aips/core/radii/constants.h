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

/// Standard errors of its Laplacian from which on a narrow disc is believed. Unit: standard errors.
/// Balances: blur of small light against radii that shrink on noise.
/// Chosen by: measurement: with 3, as elsewhere, radii far from any edge were narrowed.
/// Supported by: glass-ball, room.
inline constexpr double kSureOfCurvature = 2;

}  // namespace aips
