// Tuned constants of tables of lights and directions: each with its unit, what it balances, which
// experiment chose it, and what supports it. docs/build-on/constants.md is made from these
// comments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace aips {

/// Least number of new samples from which tables of lights are made anew; otherwise half of those
/// before. Unit: shadow rays that were to tell.
/// Balances: lights known early against sequences of eye paths that begin anew.
/// Chosen by: reasoning: not in each pass, as eye paths are stratified over the passes in between.
/// Supported by: no measurement.
inline constexpr std::uint64_t kFewestNewRays = 2048;

/// Greatest number of new samples after which tables of lights are made anew, and of those that a
/// pass brings. Unit: shadow rays that were to tell.
/// Balances: memory and the time of learning against lights known early.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint64_t kMostNewRays = 1u << 16;

/// Samples after which there is nothing more to learn of lights. Unit: shadow rays that were to
/// tell. Balances: better tables against sequences of eye paths that begin anew. Chosen by:
/// reasoning: none on record. Supported by: no measurement.
inline constexpr std::uint64_t kEnoughRays = 1u << 20;

/// Shadow rays that what was learned in another render counts for. Unit: shadow rays.
/// Balances: what is still true of the scene against what moved.
/// Chosen by: reasoning: as many as the first choices of a render rest on, several times.
/// Supported by: no measurement.
inline constexpr std::uint64_t kRememberedRays = 1u << 14;

/// Most leaves with a table of directions. Unit: leaves.
/// Balances: parallax within a leaf against memory and photons to fill a table.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kTableLeaves = 2048;

/// Vertices with a score that a leaf with a table must have met before it is split: a table has to
/// be filled before it pays to halve its place. Unit: scored vertices.
/// Balances: parallax within a leaf against tables made of few photons.
/// Chosen by: docs/notebook/2026-11-21-directions-at-bounces.md, as 64 effective photons, which 192
///   scored ones stand for.
/// Supported by: one scene only: chess (16 and 8 effective photons in place of 64).
inline constexpr std::uint32_t kTableSplitScores = 192;

/// Scored paths that count in full where things change faster than places do: the choice of tables'
/// shares, and what a whole path is worth. Unit: scored photon paths.
/// Balances: noise against what was true of a guide that knew less.
/// Chosen by: docs/notebook/2026-11-22-survival-by-score.md.
/// Supported by: no measurement (present paths against all were measured in four scenes, the number
///   was not varied).
inline constexpr double kShortMemoryPaths = 1e5;

/// Cost of looking something up that was learned: of drawing from a table and asking for its
/// density, of the way through a light's tree, of what a photon may still bring. Unit: rays.
/// Balances: guides against the rays that their time would buy.
/// Chosen by: measurement.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr double kLookUpCost = 0.3;

/// Shares of a table that are compared; the first is no table at all. What the greatest leaves to
/// the density without a table bounds weights: 1 / (1 - 3/4) of theirs. Unit: share of 1.
/// Balances: what tables gain against the greatest weight, 4.
/// Chosen by: measurement.
/// Supported by: glass-ball, chess, ajar-door, hall.
inline constexpr std::array<double, 4> kTableShares{0, 0.25, 0.5, 0.75};

/// Cells along a side of the square of directions. Unit: cells.
/// Balances: narrow lights against photons to fill a table.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr int kTableResolution = 8;

/// Of directions worth nothing one in so many is learned from, and counts as so many: they only
/// tell what directions cost, and they are most. Unit: directions.
/// Balances: time of learning against noise of the cost.
/// Chosen by: docs/notebook/2026-11-21-directions-at-bounces.md.
/// Supported by: ajar-door, hall, chess, glass-ball.
inline constexpr unsigned kWorthlessOneOf = 8;

/// Visible points with light that a leaf of shared light must have met before it is split. Unit:
/// visible points.
/// Balances: places that share light differently against moments of few samples.
/// Chosen by: reasoning: the variance of a variance takes some hundred samples.
/// Supported by: no measurement.
inline constexpr std::uint32_t kShareSplitPoints = 256;

/// What the mean over all leaves weighs in each. Unit: visible points.
/// Balances: places that had bad luck against places unlike all others.
/// Chosen by: reasoning: a quarter of what a leaf has before it is split.
/// Supported by: no measurement.
inline constexpr double kSharePrior = 64;

}  // namespace aips
