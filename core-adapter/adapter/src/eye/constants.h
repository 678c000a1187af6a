// Tuned constants of eye paths: each with its unit, what it balances, which experiment chose it,
// and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

#include "aips/core/sampling/sampling.h"
#include "base/constants.h"

namespace aips {

/// Footprints beyond so many medians count as so many. Unit: medians of the footprints.
/// Balances: a few pixels that see the horizon against scenes whose pixels do differ.
/// Chosen by: measurement.
/// Supported by: one scene only: a glass ball on a ground of 474 km.
inline constexpr float kMostMedians = 8;

/// Specular surfaces of a path from which emitters are looked for along the other way. Unit:
/// surfaces.
/// Balances: noise of emitters seen in glass against rays for all other pixels.
/// Chosen by: measurement.
/// Supported by: glass-ball, room, chess, pool (1 and 4 in its place).
inline constexpr std::uint32_t kMostBranches = 2;

/// Eye paths of a pixel in a frozen eye pass unless hitpointperpass says otherwise. Unit: eye
/// paths.
/// Balances: noise of pixels against memory and time of each gather.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kFrozenPathsPerPixel = 4;

/// Surfaces beyond the visible point from which on Russian roulette may end a continued path. Unit:
/// surfaces.
/// Balances: rays for light of many bounces against its noise.
/// Chosen by: measurement.
/// Supported by: one scene only: summerhouse (1, 3 and 4 in its place).
inline constexpr std::uint32_t kContinuedRouletteFrom = 2;

/// Of so many one in all later passes. Unit: eye paths.
/// Balances: rays that bring nothing against places whose light is met late.
/// Chosen by: docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: one scene only: hall.
inline constexpr std::uint64_t kLateExplorers = 256;

/// Chance of a path to end at a second glossy surface, for light that photons alone bring there.
/// Unit: share of 1. Balances: noise of that light against noise of all other.
/// Chosen by: measurement.
/// Supported by: one scene only: a glass ball under a spot over metal of roughness 0.25 (0.1 in its
///   place: three times the squared error).
inline constexpr float kLaterGloss = 0.25f;

/// Density that photons count for beside the bounce of a glossy lobe. Unit: 1 / steradian.
/// Balances: dots of bounces that meet a small lamp behind glass against noise of photons on lobes
/// so narrow that hardly one comes their way. Chosen by: measurement; lower ones, chosen place by
/// place, left dots and saved a tenth of the photons' variance.
/// Supported by: one scene only: a glass ball under a small lamp over metal of roughness 0.25 (0.25
///   to 4096).
inline constexpr float kCausticDensity = 4096;

/// The same for indirect light: as if photons came evenly from all directions of a hemisphere, so
/// that they carry what lies where the lobe hardly points. Unit: 1 / steradian.
/// Balances: dots of bounces that meet a bright place beside the lobe against noise of photons.
/// Chosen by: reasoning: 1 / (2 pi). More helps some scenes and hurts others.
/// Supported by: glass-of-water, veach-ajar, lamp, bathroom2, staircase2, jewellery, car, bathroom,
///   kitchen (0.25 to 4096; docs/build-on/constants.md).
inline constexpr float kIndirectDensity = 0.5f * kInvPi;

/// Most of the quotient of cosines, to the shading and to the geometric normal, that multiplies a
/// photon's power. Unit: ratio.
/// Balances: light lost along tilted surfaces, (wi.ns)^2 over this, against single photons that
/// blot an image.
/// Chosen by: measurement.
/// Supported by: one scene only: daylight (a photon of 9.8e5 in the 81st pass).
inline constexpr float kMostNormalRatio = 100;

}  // namespace aips
