// Perlin's gradient noise and the sums over octaves that are made of it.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs::shading {

/// Improved noise (Perlin 2002, "Improving Noise"), about -1 to 1 with mean 0, 0 at the points of
/// the integer lattice, period 256 along each axis. 0 where `p` isn't finite.
float perlin_noise(const Vec3& p);

/// Sum over octaves i of roughness^i * noise(1.99^i p): fractional Brownian motion.
float fractal_sum(const Vec3& p, float roughness, int octaves);

/// The same sum of absolute values: turbulence (Perlin 1985).
float turbulence(const Vec3& p, float roughness, int octaves);

}  // namespace lxs::shading
