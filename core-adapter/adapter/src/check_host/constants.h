// Tuned constants of the check of a host: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>

namespace aips {

/// Share of draws at which rounding may let a sound host down: where lobes are narrow, a direction
/// grazes, or a surface is met at its edge. Unit: share of 1.
/// Balances: findings for nothing against faults that are rare.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr double kRare = 0.02;

/// The same at lights: their edges, borders of texels. Unit: share of 1.
/// Balances: findings for nothing against faults that are rare.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr double kRareAtLight = 0.05;

/// Two distances to one light point, or two values of one quantity, are the same. Unit: share of
/// the larger.
/// Balances: findings for nothing against small errors.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr float kSame = 0.02f;

/// Differences in flux below this are left alone: tessellated lamps have a little less surface than
/// their photons start from, test surfaces some thickness. Unit: share of the flux.
/// Balances: findings for nothing against small errors.
/// Chosen by: reasoning: the surface that tessellated lamps lack.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr double kFluxTolerance = 0.03;

/// Factor by which power() may be off: it is "about", as it steers choices only. Unit: ratio.
/// Balances: findings for nothing against choices that are badly steered.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr double kPowerTolerance = 2;

/// Bound of the probability with which a sound host exceeds the errors of two estimates in any of
/// the comparisons of one light or material. Unit: probability.
/// Balances: findings for nothing against draws that a finding takes.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr double kChanceOfFinding = 1e-8;

/// How far off a surface is met again by rays that start on its wrong side. Unit: coarseness of
/// positions.
/// Balances: findings for nothing against rays that leak.
/// Chosen by: reasoning: none on record.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr float kClose = 64;

/// Draws that tell where a lobe or a light is. Unit: draws.
/// Balances: time against comparisons that miss narrow lobes.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr int kPilots = 16;

/// Two shares of light that pass surfaces straight are the same: one is a mean over draws. Unit:
/// share of the larger.
/// Balances: findings for nothing against small errors.
/// Chosen by: reasoning: 64 draws of a lobe tell its probability to a hundredth.
/// Supported by: all scenes of scenes/, whose host is sound (tests/plugin/checked_scenes_test.cpp).
inline constexpr float kSameShare = 0.1f;

}  // namespace aips
