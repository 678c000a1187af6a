// Tuned constants of strategies: each with its unit, what it balances, which experiment chose it,
// and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// What earlier passes told of shared light counts for this at each decision. Unit: share of 1.
/// Balances: guides that have learned since against few samples.
/// Chosen by: reasoning: passes double from one decision to the next.
/// Supported by: no measurement.
inline constexpr double kShareMemory = 0.5;

/// Squared error of photons over their variance where radii follow noise and bias. Unit: ratio.
/// Balances: eye paths, which have no bias, against photons.
/// Chosen by: reasoning: where the sum of noise in r^-2 and squared bias in r^4 is least, the
/// second is half of
///   the first.
/// Supported by: no measurement.
inline constexpr double kErrorOverVariance = 1.5;

/// Searches for images of emitters before the first pass. Unit: pixels.
/// Balances: time before the first pass against images that are yet unknown.
/// Chosen by: docs/notebook/2026-11-25-images-of-lamps.md.
/// Supported by: one scene only: chess.
inline constexpr double kFirstSearches = 1;

/// Share of the rays of eye paths that searches take in later passes. Unit: share of 1.
/// Balances: images found early against rays for all else.
/// Chosen by: measurement.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr double kSearching = 0.1;

}  // namespace aips
