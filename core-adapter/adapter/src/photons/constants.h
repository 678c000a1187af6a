// Tuned constants of photon paths: each with its unit, what it balances, which experiment chose it,
// and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Photon paths of a round of chains, and of a pilot pass. Unit: photon paths.
/// Balances: work for all threads against memory, and against chains without a path for long.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kRoundPaths = 1u << 14;

/// Paths of a block, which one thread traces, and over which the photons that come from splitting
/// are bounded. Unit: photon paths.
/// Balances: threads that wait for the last block against time spent between blocks.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kPathsPerBlock = 256;

/// Photons of one path that may come from splitting others. Unit: photons.
/// Balances: noise behind narrow openings against memory and paths that never end.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMostSplits = 16;

/// Chains that walk side by side in a pass, at least. Unit: chains.
/// Balances: work for all threads, with bits that do not depend on them, against the length of each
///   chain.
/// Chosen by: reasoning: a fixed number, so that bits do not depend on the number of threads.
/// Supported by: no measurement.
inline constexpr std::uint32_t kChainCount = 64;

/// The same, at most. Unit: chains.
/// Balances: work for all threads against memory.
/// Chosen by: reasoning: several for each of 64 threads.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMostChains = 512;

/// Paths of a chain in a pass, at least, where there are more than the fewest. Unit: photon paths.
/// Balances: work for all threads against the length of each chain.
/// Chosen by: docs/notebook/2026-11-26-lagging-guide.md.
/// Supported by: no measurement.
inline constexpr std::uint32_t kPathsPerChain = 2048;

/// Steps of a chain from one start to the next, at least, where chains explore. Unit: steps.
/// Balances: many starts against the paths around each.
/// Chosen by: reasoning: at an acceptance of a quarter, four paths of a start are visited.
/// Supported by: no measurement.
inline constexpr std::uint32_t kShortestSegment = 16;

/// Rounds of photon paths that explore before the first pass, at most. Unit: rounds.
/// Balances: time before the first pass against scenes of which next to nothing is seen.
/// Chosen by: reasoning: they then take a few tenths of a second.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMostExploringRounds = 16;

/// Those of them that found visible paths, at most. Unit: rounds.
/// Balances: time before the first pass against what a guide would learn by itself from then on.
/// Chosen by: docs/measured/parts.md.
/// Supported by: a public classroom, summerhouse, car, jewellery, daylight (16 in its place:
/// variance
///   times time after 32 passes of 120 pixels 1.4, 1.4, 1.1, 1.0 and 0.65 times as much).
inline constexpr std::uint32_t kRoundsWithFinds = 8;

/// How far from a visible point photons count as visible to a chain. Discs that just touch, or do
/// not, are islands to a chain, which stays on one for long. Unit: mean radii.
/// Balances: islands against paths that nothing gathers.
/// Chosen by: measurement.
/// Supported by: one scene only: summerhouse (1 to 4 in its place).
inline constexpr float kChainReach = 2;

/// Steps of a chain over which the size of mutations is learned from round to round. Later it
/// changes between passes only, so that it does not depend on the states of the chains it moves.
/// Unit: steps.
/// Balances: a size that fits early against paths that depend on their size a little.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint64_t kMutationLearningSteps = 1024;

/// Most surfaces, of those that a photon passes straight next to its light, that do not count for
/// its depth: shadow rays pass them without counting. Unit: surfaces.
/// Balances: light through many panes at the end of short paths against memory for photons.
/// Chosen by: reasoning: four panes of two surfaces each.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMostFreeSurfaces = 8;

}  // namespace aips
