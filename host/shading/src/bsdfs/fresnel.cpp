// Reflectance of smooth interfaces: exact formulas.
#include "fresnel.h"

#include <algorithm>
#include <cmath>

namespace lxs::shading {
namespace {

float conductor_channel(float c, float eta, float k) {
    const float s2 = std::max(0.0f, 1 - c * c);
    const float d = eta * eta - k * k - s2;
    const float ab2 = std::sqrt(d * d + 4 * eta * eta * k * k);  // a^2 + b^2 of Born & Wolf
    const float a = std::sqrt(std::max(0.0f, 0.5f * (ab2 + d)));
    const float perpendicular_denominator = ab2 + 2 * a * c + c * c;
    if (!(perpendicular_denominator > 0)) return 1;
    const float rs = (ab2 - 2 * a * c + c * c) / perpendicular_denominator;
    const float denominator = c * c * ab2 + 2 * a * c * s2 + s2 * s2;
    const float rp = rs * (c * c * ab2 - 2 * a * c * s2 + s2 * s2) / std::max(denominator, 1e-30f);
    return std::clamp(0.5f * (rs + rp), 0.0f, 1.0f);
}

}  // namespace

float fresnel_dielectric(float cos_i, float eta) {
    const float c = std::clamp(cos_i, 0.0f, 1.0f);
    const float sin2_t = (1 - c * c) / (eta * eta);
    if (sin2_t >= 1) return 1;
    const float cos_t = std::sqrt(1 - sin2_t);
    const float perpendicular = c + eta * cos_t, parallel = eta * c + cos_t;
    if (!(perpendicular > 0) || !(parallel > 0)) return 1;
    const float rs = (c - eta * cos_t) / perpendicular;
    const float rp = (eta * c - cos_t) / parallel;
    return std::min(1.0f, 0.5f * (rs * rs + rp * rp));
}

Rgb fresnel_conductor(float cos_i, const FresnelValue& value) {
    const float c = std::clamp(cos_i, 0.0f, 1.0f);
    return {conductor_channel(c, value.eta.x, value.k.x),
            conductor_channel(c, value.eta.y, value.k.y),
            conductor_channel(c, value.eta.z, value.k.z)};
}

FresnelValue fresnel_from_reflectance(const Rgb& r) {
    FresnelValue value;
    value.conductor = true;
    for (int i = 0; i < 3; ++i) {
        const float clamped = r[i] >= 0 ? std::min(r[i], 0.999f) : 0.0f;  // NaN: 0
        const float root = std::sqrt(clamped);
        value.eta[i] = (1 + root) / (1 - root);
        value.k[i] = 2 * std::sqrt(clamped / (1 - clamped));
    }
    return value;
}

}  // namespace lxs::shading
