// The gather radius as a function of the photon paths shot.
// Source: Knaus & Zwicker 2011, "Progressive photon mapping: a probabilistic approach", eq. 15.
#pragma once

namespace aips {

/// Radius after `paths_shot` photon paths: the recursion r_{i+1}^2 = r_i^2 (i + alpha) / (i + 1) in
/// closed form, extended to real n = 1 + paths_shot / reference_paths:
///
///     r^2(n) = r0^2 Gamma(n + alpha) / (Gamma(1 + alpha) Gamma(n + 1)),
///
/// about r0^2 n^(alpha - 1) / Gamma(1 + alpha). It depends on photons, not on passes: a method that
/// makes longer passes gains nothing from a larger radius. Is r0 for no paths; falls monotonously,
/// but never below `minimum` (itself cut to r0). alpha in (0, 1]; 1 keeps r0. Arguments out of
/// range, NaN among them, are clamped to it; the result is finite and positive.
float knaus_zwicker_radius(double initial_radius, double paths_shot, double reference_paths,
                           double alpha, double minimum = 1e-30);

}  // namespace aips
