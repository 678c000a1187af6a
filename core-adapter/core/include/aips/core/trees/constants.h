// Tuned constants of trees: each with its unit, what it balances, which experiment chose it, and
// what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aips {

/// Most leaves over which one thing is learned: the contribution of places, or of starts over all
/// lights.
/// Unit: leaves.
/// Balances: detail against memory, look-ups and photons to learn from.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMostLearnedLeaves = 8192;

/// Photons with a score, or seeds, that a leaf of a light's tree must have met before it is split.
/// Unit: scored photons.
/// Balances: detail against halves that differ by chance.
/// Chosen by: measurement.
/// Supported by: sun-window, hall (8 in its place).
inline constexpr std::uint32_t kStartSplitScores = 32;

/// Power of |f| / sqrt(cost) that the density of starts follows. Unit: exponent.
/// Balances: the best density if |f| were known against weights where it is wrong.
/// Chosen by: measurement.
/// Supported by: sun-window, summerhouse, chess, glass-ball, ajar-door, hall; sun-window again
///   (docs/notebook/2026-11-23-one-scale-for-scores.md).
inline constexpr double kStartPower = 0.75;

/// What the parent's mean weighs in each node of a light's tree. Unit: effective scored photons.
/// Balances: places that had bad luck against photons sent where nothing is.
/// Chosen by: measurement.
/// Supported by: one scene only: sun-window (1 against 4; elsewhere varied with the power alone).
inline constexpr double kStartPrior = 1;

/// Fewer seeds than this do not say how narrow the region is that they come from. Unit: seeds.
/// Balances: starts found in a few passes against halving on chance.
/// Chosen by: measurement.
/// Supported by: open-ground, sun-window (8 in its place).
inline constexpr std::size_t kFocusPoints = 16;

/// A leaf is halved at once where its seeds take less of it than this, along any axis: however they
/// lie about its middle, where a greedy split gains nothing, each half then has them at one end.
/// Unit: share of the leaf's side.
/// Balances: starts found in a few passes against leaves spent on wide groups.
/// Chosen by: measurement.
/// Supported by: open-ground (a tenth in its place), hall, prism (half).
inline constexpr double kFocusNarrow = 0.25;

/// Samples with a score that a leaf of places must have met since it came to be before it is split,
/// be it scores or lights that are learned there. Those without a score tell where
/// others are not, however uneven scores may be. Unit: scored samples.
/// Balances: detail against halves that differ by chance.
/// Chosen by: measurement: one number for both in place of 16 and 64.
/// Supported by: glass-ball, hall, ajar-door, pool, chess, summerhouse, daylight, car.
inline constexpr std::uint32_t kPlaceSplitScores = 64;

/// A leaf of places with more than this share of the mass is halved even if its halves look alike:
/// a field that is symmetric about the plane shows its shape only in the quarters. Unit: share of
/// the whole mass.
/// Balances: detail where much is at stake against leaves spent where all is even.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kSplitMass = 1.0 / 256;

/// What the mean of the parent, or of all places, weighs in each place, whatever is learned there:
/// below it what a leaf met is not trusted. Unit: scored samples.
/// Balances: detail against what few samples say.
/// Chosen by: measurement: one number for all in place of 4, 4 and 8.
/// Supported by: glass-ball, hall, ajar-door, pool, chess, summerhouse, daylight, car.
inline constexpr double kPlacePrior = 8;

}  // namespace aips
