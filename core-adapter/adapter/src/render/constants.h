// Tuned constants of the pass loop: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

namespace aips {

/// Part of a pixel to which positions may be rounded at what is seen before the log warns of it.
/// Unit: pixels.
/// Balances: warnings for nothing against images that rounding spoils.
/// Chosen by: docs/notebook/2026-11-24-stress-scale-and-energy.md.
/// Supported by: no measurement (rooms far from the origin were measured, the threshold was not
///   varied).
inline constexpr double kMostOfPixel = 0.25;

}  // namespace aips
