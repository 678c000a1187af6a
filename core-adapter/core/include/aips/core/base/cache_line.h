// What keeps threads out of each other's way.
#pragma once

#include <cstddef>

namespace aips {

/// Alignment of what one thread writes while others write its neighbours in an array, bytes: a line
/// of the cache is then of one thread (x86-64, and most others).
inline constexpr std::size_t kCacheLine = 64;

}  // namespace aips
