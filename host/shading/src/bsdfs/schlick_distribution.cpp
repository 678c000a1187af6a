// Microfacet distribution of Schlick 1994: sampling.
#include "schlick_distribution.h"

#include <algorithm>

namespace lxs::shading {
namespace {

/// Below it a grain makes no visible difference, but numbers would overflow.
constexpr float kMinIsotropy = 1e-4f;

}  // namespace

SchlickDistribution::SchlickDistribution(float u_roughness, float v_roughness) {
    const float u = std::clamp(u_roughness, kMinRoughness, 1.0f);
    const float v = std::clamp(v_roughness, kMinRoughness, 1.0f);
    const float ratio = std::min(u, v) / std::max(u, v);
    roughness_ = u * v;
    isotropy_ = std::max(ratio * ratio, kMinIsotropy);
    grain_along_y_ = v < u;
}

float SchlickDistribution::azimuth(const Vec3& h) const {
    const float x = std::abs(h.x), y = std::abs(h.y);
    if (!(x > 0 || y > 0)) return 1;  // the normal has no azimuth; as in LuxRender
    const float t = (grain_along_y_ ? std::atan2(y, x) : std::atan2(x, y)) * (2 * kInvPi);
    const float p2 = isotropy_ * isotropy_, d = p2 + (1 - p2) * t * t;
    return p2 / (d * std::sqrt(d));
}

float SchlickDistribution::projected_area(float c) const {
    // A is p^2 at least, so that this share of the facets looks alike to all sides (Walter et al.
    // 2007, equation 34) ...
    const float even = 0.5f * (c + std::sqrt(roughness_ + (1 - roughness_) * c * c));
    if (isotropy_ >= 1) return even;
    // ... and of the rest all lean to and from the direction at most: c plus the integral of what
    // of them is turned away.
    const float slope = std::sqrt(roughness_ * std::max(0.0f, 1 - c * c));
    const float aligned = c + 0.5f * slope * std::atan2(slope, c);
    return std::lerp(aligned, even, isotropy_ * isotropy_);
}

Vec2 SchlickDistribution::sample_azimuth(float u) const {
    if (isotropy_ >= 1) return {std::cos(2 * kPi * u), std::sin(2 * kPi * u)};
    const float quadrant = std::floor(4 * u), rest = 4 * u - quadrant;
    const float p2 = isotropy_ * isotropy_;
    const float t =
        isotropy_ * rest / std::sqrt(1 - rest * rest * (1 - p2));  // A's integral is rest
    const float angle = 0.5f * kPi * t;
    const float along = quadrant < 2 ? std::cos(angle) : -std::cos(angle);
    const float across = std::fmod(quadrant, 2.0f) < 1 ? std::sin(angle) : -std::sin(angle);
    return grain_along_y_ ? Vec2(along, across) : Vec2(across, along);
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
