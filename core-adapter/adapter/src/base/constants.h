// The tuned constant that many parts share: its unit, what it balances, how it was chosen, and what
// supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Warm-up passes, from which on what passes tell is believed: how many photons pay, what light
/// they lose, where radii are to go. Until then all visible points tell how light is shared and
/// what separates photons from them, many eye paths explore, and a warm start counts for less.
/// Unit: passes, a power of two. Balances: decisions soon against decisions by chance. Chosen by:
/// measurement: one number in place of 4, 8 and 16. Supported by: furnace, chess, prism, daylight,
/// summerhouse, car, glass-ball, hall, ajar-door,
///   pool.
inline constexpr std::uint64_t kWarmUpPasses = 8;

}  // namespace aips
