// What a vector's growth may cost, for bounds of memory.
#pragma once

#include <cstddef>

namespace aips {

/// Vectors grow by doubling: their capacity may be as many times what they hold.
inline constexpr std::size_t kVectorGrowth = 2;

}  // namespace aips
