// Reflectance of smooth interfaces.
// Sources: Born & Wolf, Principles of Optics, sections 1.5 and 14.2 (exact, unpolarised);
// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering" (approximation).
#pragma once

#include "lxs/scene/texture.h"
#include "lxs/sdk/types.h"

namespace lxs::shading {

/// Share reflected at a dielectric interface. `cos_i` in [0, 1] on the incident side;
/// `eta` = index behind the interface / index in front of it. 1 at total internal reflection.
float fresnel_dielectric(float cos_i, float eta);

/// Share reflected per channel by a conductor (or, with k = 0, a dielectric) in vacuum.
Rgb fresnel_conductor(float cos_i, const FresnelValue& value);

/// Schlick's approximation for reflectance `r0` at normal incidence.
inline Rgb fresnel_schlick(float cos_i, const Rgb& r0) {
    const float m = 1 - cos_i;
    const float m5 = m * m * m * m * m;
    return r0 + (Rgb(1.0f) - r0) * m5;
}

/// Index of refraction of a non-absorbing material that reflects `r` at normal incidence, and
/// extinction coefficient of one of index 1 that does; both together stand for a coloured metal.
FresnelValue fresnel_from_reflectance(const Rgb& r);

}  // namespace lxs::shading
