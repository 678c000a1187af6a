// Tuned constants of density estimation: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Least cosine between the normals of a photon's surface and a visible point's: photons of
/// surfaces turned by more belong to another one. Unit: cosine.
/// Balances: light that leaks around corners against photons lost on curved surfaces.
/// Chosen by: reasoning: what is turned by more than 45 degrees is another surface.
/// Supported by: no measurement.
inline constexpr float kMinNormalAgreement = 0.7071f;

/// Half thickness of the slab around the tangent plane: a sphere of radius R bends away by r^2 / (2
/// R), so this takes all photons of surfaces with R >= r. Unit: radii.
/// Balances: light that leaks through thin walls against photons lost on curved surfaces.
/// Chosen by: reasoning: the bend of a sphere as narrow as the search.
/// Supported by: no measurement.
inline constexpr float kSlab = 0.5f;

/// Trials for each place of a gather disc that is no surface, which bounds the factor of an edge's
/// photons at one more. Unit: trials.
/// Balances: light lost in corners against single photons that blot thin or ragged things.
/// Chosen by: docs/notebook/2026-11-26-edges.md.
/// Supported by: room, summerhouse, magic-lamp, daylight, pool (4 and 16 in its place).
inline constexpr std::uint32_t kMostTrials = 2;

/// Side of the grid of places that are tried first where a pixel is at an edge. Unit: places.
/// Balances: noise of edges against rays.
/// Chosen by: docs/notebook/2026-11-26-edges.md.
/// Supported by: room, cornell-box, glass-ball (1 and 3 in its place).
inline constexpr std::uint32_t kEdgeGrid = 2;

/// Passes for which a pixel counts as one at an edge after it has been found there. Unit: passes.
/// Balances: rays where radii have shrunk away from an edge against noise where few discs reach it.
/// Chosen by: reasoning: radii shrink by a tenth from the 32nd pass to the 64th.
/// Supported by: no measurement.
inline constexpr std::uint8_t kEdgePasses = 32;

/// Chance that a place of a gather disc passes for surface unasked, over the relative variance of
/// what photons have brought. 1 would be best at a straight edge, if photons told their variance.
/// Unit: ratio.
/// Balances: noise that the correction multiplies against seams that it leaves.
/// Chosen by: docs/notebook/2026-11-26-edges.md.
/// Supported by: room, hall, summerhouse, daylight, magic-lamp (1 and 16 in its place).
inline constexpr double kBeliefOfNoise = 4;

/// Photons that a visible point asks for in warm-up passes. Unit: photons.
/// Balances: rays of the first passes against light that leaks in them.
/// Chosen by: reasoning: of light of which a share q is separated at most q (1 - q), a quarter of
/// what is left, stays.
/// Supported by: no measurement.
inline constexpr std::uint32_t kFirstOcclusionAsks = 2;

/// Weight of earlier passes in the share of photons that reach a part of the image. Unit: ratio.
/// Balances: noise of the share against passes until it follows the radius.
/// Chosen by: reasoning: ten passes or so.
/// Supported by: no measurement.
inline constexpr float kOcclusionMemory = 0.9f;

}  // namespace aips
