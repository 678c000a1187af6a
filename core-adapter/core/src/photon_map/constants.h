// Tuned constants of grids over points: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aips {

/// Bits of the occupancy for each visible point. Unit: bits.
/// Balances: memory and misses of the cache against landings that are kept for nothing.
/// Chosen by: reasoning: neighbouring points share cells, so that most bits stay clear.
/// Supported by: no measurement.
inline constexpr std::size_t kBitsPerPoint = 16;

/// Bits of the filter for each landing, where there are few. Unit: bits.
/// Balances: queries in vain against a filter that the cache holds.
/// Chosen by: reasoning: a landing reaches eight cells at most, so that one in eight passes in
/// vain. Supported by: no measurement.
inline constexpr std::size_t kFilterBitsPerPoint = 64;

/// Queries for each landing from which on the filter is asked first. Unit: queries.
/// Balances: time to build it against queries that find nothing.
/// Chosen by: reasoning: a landing is within reach of a dozen points, with one in each pixel.
/// Supported by: no measurement.
inline constexpr std::size_t kQueriesOfFewLandings = 8;

/// Most parts that points are dealt out to before each part is sorted. Unit: partitions.
/// Balances: sorts within a first-level cache against streams that are written at once.
/// Chosen by: reasoning: of a million points 4096 fall into a part, which the cache holds.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMaxPartitions = 256;

}  // namespace aips
