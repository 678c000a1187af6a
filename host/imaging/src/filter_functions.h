// Pixel filters as functions of the distance from the pixel's centre.
// Sources: Mitchell & Netravali 1988; Harris 1978 (Blackman-Harris window); Duchon 1979 (Lanczos).
#pragma once

namespace lxs {

/// Mitchell-Netravali cubic; support |x| < 2, integral 1.
double mitchell_1d(double x, double b, double c);

/// LuxRender's "supersample": three cubics, 4/3 apart, weighted so that the outer two fill the
/// negative lobes of the one in the middle; support |x| < kSupersampledReach * 2.
double supersampled_mitchell_1d(double x, double b, double c);
inline constexpr double kSupersampledReach = 5.0 / 3;

/// exp(-alpha x^2), lowered so that it ends continuously at `radius`, zero beyond.
double gaussian_1d(double x, double radius, double alpha);

/// Tent: radius - |x|, zero beyond.
double triangle_1d(double x, double radius);

/// Four-term Blackman-Harris window over [-radius, radius]; 1 at the centre.
double blackman_harris_1d(double x, double radius);

/// Sinc over [-radius, radius] with x scaled to [-1, 1] * tau lobes, under a Lanczos window.
double lanczos_sinc_1d(double x, double radius, double tau);

}  // namespace lxs
