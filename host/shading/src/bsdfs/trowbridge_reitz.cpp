// Microfacet distribution of Trowbridge and Reitz: sampling.
#include "trowbridge_reitz.h"

#include <algorithm>

#include "schlick_distribution.h"

namespace lxs::shading {

TrowbridgeReitz::TrowbridgeReitz(float alpha_x, float alpha_y)
    : alpha_x_(std::clamp(alpha_x, SchlickDistribution::kMinRoughness, 1.0f)),
      alpha_y_(std::clamp(alpha_y, SchlickDistribution::kMinRoughness, 1.0f)) {}

Vec3 TrowbridgeReitz::sample_visible(const Vec3& wo, const Vec2& u) const {
    // On facets stretched to a sphere, h is halfway between wo and a point of the cap that wo sees
    // reflected (Dupuy & Benyoub 2023, listing 3).
    const Vec3 stretched = Vec3(alpha_x_ * wo.x, alpha_y_ * wo.y, wo.z).normalized();
    const float z = (1 - u.x) * (1 + stretched.z) - stretched.z;
    const float sine = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * kPi * u.y;
    const Vec3 h = Vec3(sine * std::cos(phi), sine * std::sin(phi), z) + stretched;
    return Vec3(alpha_x_ * h.x, alpha_y_ * h.y, std::max(h.z, 1e-7f)).normalized();
}

}  // namespace lxs::shading
