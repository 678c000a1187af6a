// Tuned constants of light in media: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

namespace aips {

/// Automatic radius of beams: photons in media are sparser than on surfaces, and their light is
/// smoother. Unit: radii of the surfaces' estimate.
/// Balances: noise against blur across the beam.
/// Chosen by: reasoning: photons in media are sparser, and their light is smoother.
/// Supported by: no measurement.
inline constexpr double kSurfaceRadii = 3;

}  // namespace aips
