// Tuned constants of guide=adaptive: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aips {

/// Visible points of which one is walked from. Unit: visible points.
/// Balances: time of walks against starts that are found.
/// Chosen by: measurement.
/// Supported by: pool, hall, glass-ball, chess, prism, sun-window (4 in its place).
inline constexpr std::uint32_t kSeedGroup = 16;

/// Specular bounces that a walk follows. Unit: bounces.
/// Balances: time of walks against lights behind several panes.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMaxSeedBounces = 4;

/// Walks without any seed after which no more are done. Unit: walks.
/// Balances: time of walks against lights that are rarely met.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint64_t kSeedTrialWalks = 4096;

/// Passes that begin before so many paths are seeded from the eye. Unit: photon paths.
/// Balances: time of walks against what photons have not met yet.
/// Chosen by: reasoning: from then on photons tell more than walks do.
/// Supported by: no measurement.
inline constexpr std::uint64_t kSeededPaths = 2'000'000;

/// Share of the photons that start by the density of seeds, until enough was learned. Unit: share
/// of 1.
/// Balances: finding the picture against following seeds that name it roughly.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kSeedStarts = 0.25;

/// Share of the photons that start by the density of seeds after that. Unit: share of 1.
/// Balances: light that photons have missed against photons that follow rough seeds.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLearnedSeedStarts = 0.05;

/// Photons worth something that count as enough learned. Unit: scored photons.
/// Balances: seeds against what photons tell.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kLearnedScores = 256;

/// Photon paths after which photons count in full, and of the first trial of a part. Unit: photon
/// paths.
/// Balances: fireflies of a guide that knows little against the photons that count for less.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLearningPaths = 5e5;

/// Photon paths until which many are scored, each iteration before the next. Unit: photon paths.
/// Balances: time of learning against how soon much is known: with half as many places went on to
/// be halved, and memory to grow, for long.
/// Chosen by: docs/notebook/2026-11-23-one-scale-for-scores.md.
/// Supported by: sun-window, hall (two and a half million).
inline constexpr std::uint64_t kEagerPaths = 1'000'000;

/// Photon paths of an iteration; photon_schedule.h weighs the first photons by as many.
/// Unit: photon paths.
/// Balances: work for all threads and little time between iterations against a guide that lags
///   behind.
/// Chosen by: measurement.
/// Supported by: cornell-box, glass-ball, chess (longer ones).
inline constexpr std::uint32_t kIterationPaths = 1u << 14;

/// Groups that paths are dealt out to, an odd number; the median of what they say is taken. Unit:
/// groups.
/// Balances: verdicts that one path decides against noise of each group.
/// Chosen by: measurement.
/// Supported by: one scene only: a corridor with fog.
inline constexpr std::size_t kMomentGroups = 5;

}  // namespace aips
