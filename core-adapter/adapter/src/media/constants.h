// Tuned constants of light in media: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Automatic radius of beams: photons in media are sparser than on surfaces, and their light is
/// smoother. Unit: radii of the surfaces' estimate.
/// Balances: noise against blur across the beam.
/// Chosen by: reasoning: photons in media are sparser, and their light is smoother.
/// Supported by: no measurement.
inline constexpr double kSurfaceRadii = 3;

/// Photons of a beam that are asked for what separates them, where something ended near it. Unit:
/// photons. Balances: rays, two a photon, against noise of the factor that stands for all.
/// Chosen by: measurement.
/// Supported by: six scenes with fog, dust, water and milk (2 has 0.95 of its efficiency).
inline constexpr std::uint32_t kAsksAtBoundary = 4;

}  // namespace aips
