// Microfacet distribution of Schlick 1994: sampling.
#include "schlick_distribution.h"

#include <algorithm>

namespace lxs::shading {
namespace {

/// Below these LuxRender's roughness makes no visible difference, but numbers would overflow.
constexpr float kMinRoughness = 6e-3f;
constexpr float kMinIsotropy = 1e-4f;

}  // namespace

SchlickDistribution::SchlickDistribution(float u_roughness, float v_roughness) {
    const float u = std::clamp(u_roughness, kMinRoughness, 1.0f);
    const float v = std::clamp(v_roughness, kMinRoughness, 1.0f);
    const float ratio = std::min(u, v) / std::max(u, v);
    roughness_ = u * v;
    widest_ = std::max(u, v) * std::max(u, v);
    isotropy_ = std::max(ratio * ratio, kMinIsotropy);
    grain_along_y_ = v < u;
}

float SchlickDistribution::azimuth(const Vec3& h) const {
    const float x2 = h.x * h.x, y2 = h.y * h.y;
    if (!(x2 + y2 > 0)) return 1;
    const float w2 = (grain_along_y_ ? y2 : x2) / (x2 + y2);
    const float p2 = isotropy_ * isotropy_;
    return std::sqrt(isotropy_ / (p2 + (1 - p2) * w2));
}

Vec2 SchlickDistribution::sample_azimuth(float u) const {
    if (isotropy_ >= 1) return {std::cos(2 * kPi * u), std::sin(2 * kPi * u)};
    // A has no elementary integral, A^2 / (2 pi) has: tan(phi) = tan(psi) / p with psi uniform.
    // Half of the directions come from it and half are uniform, so that A never exceeds the
    // density's share (1 + A^2) / 2.
    const bool uniform = u < 0.5f;
    const float psi = 2 * kPi * (uniform ? 2 * u : 2 * u - 1);
    const float along = std::cos(psi) * (uniform ? 1.0f : isotropy_), across = std::sin(psi);
    const float scale = 1 / std::sqrt(along * along + across * across);
    return grain_along_y_ ? Vec2(across * scale, along * scale)
                          : Vec2(along * scale, across * scale);
}

Vec3 SchlickDistribution::sample(const Vec2& u) const {
    // Inverse of the integral of Z over the solid angle.
    const float cos2 = (1 - u.x) / (1 - u.x * (1 - roughness_));
    const float sin2 = u.x * roughness_ / (1 - u.x * (1 - roughness_));
    const Vec2 phi = sample_azimuth(u.y);
    const float sine = std::sqrt(sin2);
    return {sine * phi.x, sine * phi.y, std::sqrt(cos2)};
}

}  // namespace lxs::shading
