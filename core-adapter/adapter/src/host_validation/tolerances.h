// What a sound host may be off by, and how surely a fault is one. No image depends on these
// numbers; all scenes of scenes/, whose host is sound, pass with them
// (tests/plugin/checked_scenes_test.cpp).
#pragma once

namespace aips {

/// Share of draws at which rounding may let a sound host down: where lobes are narrow, a direction
/// grazes, or a surface is met at its edge.
inline constexpr double kRare = 0.02;

/// The same at lights: their edges, borders of texels.
inline constexpr double kRareAtLight = 0.05;

/// Two distances to one light point, or two values of one quantity, are the same: share of the
/// larger by which they may differ.
inline constexpr float kSame = 0.02f;

/// Share of the flux that may be missing: tessellated emitters have a little less surface than
/// their photons start from, test surfaces some thickness.
inline constexpr double kFluxTolerance = 0.03;

/// Factor by which power() may be off: it is "about", as it steers choices only.
inline constexpr double kPowerTolerance = 2;

/// Bound of the probability with which a sound host exceeds the errors of two estimates in any of
/// the comparisons of one light or material.
inline constexpr double kChanceOfFinding = 1e-8;

/// How far off a surface is met again by rays that start on its wrong side, in coarsenesses of
/// positions.
inline constexpr float kClose = 64;

/// Draws that tell where a lobe or a light is.
inline constexpr int kPilots = 16;

/// Two shares of light that pass surfaces straight are the same: share of the larger by which they
/// may differ. One is a mean over 64 draws, which know it to a hundredth.
inline constexpr float kSameShare = 0.1f;

}  // namespace aips
