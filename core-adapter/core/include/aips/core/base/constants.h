// Tuned constants of whatever is learned: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Standard errors by which something must stand out before it is believed: a difference between
/// halves of a place, light that photons or eye paths miss, blur. Unit: standard errors.
/// Balances: decisions soon against decisions by chance.
/// Chosen by: reasoning: one in 700 is chance.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr double kSureErrors = 3;

/// Share of what a guide draws that is drawn as without it: a defensive mixture (Owen and Zhou
/// 2000), which bounds weights by its inverse. Unit: share of 1.
/// Balances: the greatest weight, 1 / 0.15, against noise where the guide is right.
/// Chosen by: measurement.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr double kPlainShare = 0.15;

/// Least gain, second moment times cost without a guide over that with one, at which one comes into
/// use. Unit: ratio.
/// Balances: guides in use against the noise of the verdict.
/// Chosen by: measurement: what stratified starts bring, 1.05 to 1.23.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr double kLeastGain = 1.25;

/// While little is known, one of so many is learned from: photon paths that are scored, shadow
/// rays, eye paths that explore. Unit: paths or rays. Balances: time of learning against how soon
/// much is known. Chosen by: docs/notebook/2026-11-21-directions-at-bounces.md. Supported by:
/// ajar-door, hall, chess (all in its place).
inline constexpr std::uint32_t kEarlyOneOf = 4;

/// One of so many later: photon paths, visible points that tell how light is shared, or what
/// separates a photon from them. Unit: paths or points.
/// Balances: time of learning against following what changes.
/// Chosen by: reasoning: learning takes no more than a few rays in a hundred.
/// Supported by: daylight, chess, car, hall, glass-ball, summerhouse, sun-window, bathroom,
///   jewellery, pool, room, ajar-door, magic-lamp (others in its place:
///   docs/build-on/constants.md).
inline constexpr std::uint32_t kLateOneOf = 16;

}  // namespace aips
