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

/// Rounds of these: searches go on around what was found before. Unit: rounds.
/// Balances: images close to others against searches anywhere.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr unsigned kFirstRounds = 4;

/// Share of the rays of eye paths that searches take in later passes while images are easy to find.
/// Unit: share of 1.
/// Balances: images found early against rays for all else.
/// Chosen by: docs/notebook/2026-11-25-images-of-lamps.md.
/// Supported by: one scene only: chess.
inline constexpr double kMostSearching = 0.15;

/// Least part of that. Unit: share of 1.
/// Balances: rays that find nothing against images found late.
/// Chosen by: reasoning: one ray in a hundred.
/// Supported by: no measurement.
inline constexpr double kLeastSearching = 0.07;

/// Rays for each new image up to which they are easy to find. Unit: rays.
/// Balances: as that of the share.
/// Chosen by: docs/notebook/2026-11-25-images-of-lamps.md.
/// Supported by: one scene only: chess.
inline constexpr double kEasyImage = 4000;

/// What searches count one round later, where it is told how easy images are to find. Unit: share
/// of 1.
/// Balances: knowing it now against knowing it well.
/// Chosen by: reasoning: some ten passes.
/// Supported by: no measurement.
inline constexpr double kSearchMemory = 0.9;

}  // namespace aips
