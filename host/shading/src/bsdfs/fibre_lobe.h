// What a rough fibre does to light: a phase function about its direction.
// Sources: d'Eon, Francois, Hill, Letteri & Aubry 2011, "An Energy-Conserving Hair Reflectance
// Model" (along the fibre); Marschner, Jensen, Cammarano, Worley & Hanrahan 2003, "Light Scattering
// from Human Hair Fibers" (around it, reflection by the surface).
#pragma once

#include "lxs/sdk/types.h"

namespace lxs::shading {

/// Scatters into the cone of directions that a smooth fibre would mirror light into, blurred along
/// the fibre by the `variance` of its surface's inclination, rad^2. Around the fibre a share of
/// 1 - `through` is reflected by the surface, the rest goes through and mostly on.
/// p(a, b) = p(b, a), and the integral over all directions is 1.
class FibreLobe {
  public:
    FibreLobe(float variance, float through);

    /// p of two unit directions pointing away from the fibre, per steradian. `tangent`: unit.
    float value(const Vec3& tangent, const Vec3& a, const Vec3& b) const;
    /// Draws b with density value(tangent, a, b) from three numbers in [0, 1).
    Vec3 sample(const Vec3& tangent, const Vec3& a, const Vec2& u, float u_around) const;

  private:
    /// Density of the sine of the angle to the normal plane, which is `sine_a` on the other side.
    float along(float sine_a, float cosine_a, float sine_b, float cosine_b) const;
    /// Density of the difference in azimuth (0: back to where the light came from).
    float around(float cosine) const;

    float variance_, through_;
    float tail_;   ///< exp(-2 / variance)
    float scale_;  ///< 1 / (variance (1 - tail))
};

}  // namespace lxs::shading
