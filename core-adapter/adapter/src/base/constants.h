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

/// The darkest that a pixel is taken for, eps: brighter pixels weigh by their relative error,
/// darker ones nearly alike. With a fiftieth the few photons that the darkest get decide most of
/// the scores, and the guide follows their noise for long. Unit: mean luminances of the image.
/// Balances: relative error of dark pixels against scores that few photons decide.
/// Chosen by: docs/notebook/2026-11-24-where-photons-are-split.md.
/// Supported by: ajar-door, glass-ball, hall, sun-window, chess, ring, pool, prism.
inline constexpr double kDarkestShare = 0.5;

/// Side of the squares of the film whose pixels learn together: what separates photons from them,
/// how noisy photons are; one of them is probed in a pass. Unit: pixels.
/// Balances: places that differ against passes until something is known.
/// Chosen by: reasoning: 16 visible points of a pass find what separates a twentieth of the light.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr std::uint32_t kFilmCell = 4;

}  // namespace aips
