// Tuned constants of density estimation: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Photons that wait for a gather, landings or collisions in media; one iteration may exceed it.
/// Unit: photons.
/// Balances: memory against gathers, each of which looks at all visible points.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kWaitingPhotons = 1u << 20;

/// Least cosine between the normals of a landing's surface and a visible point's: photons of
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

}  // namespace aips
