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

/// Most parts that points are dealt out to before each part is sorted. Unit: partitions.
/// Balances: sorts within a first-level cache against streams that are written at once.
/// Chosen by: reasoning: of a million points 4096 fall into a part, which the cache holds.
/// Supported by: no measurement.
inline constexpr std::uint32_t kMaxPartitions = 256;

}  // namespace aips
