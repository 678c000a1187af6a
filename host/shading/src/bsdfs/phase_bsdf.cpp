// A surface that scatters like a particle: sampling and values.
#include "phase_bsdf.h"

#include <algorithm>
#include <cmath>

#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"

namespace lxs::shading {
namespace {

constexpr float kMinPhaseCosine = 1e-4f;

/// Schlick's k of a mean cosine g (Blasi, Le Saec & Schlick 1993, with the fit that LuxRender has).
float schlick_k(float g) {
    return std::clamp(g * (1.55f - 0.55f * g * g), -0.999f, 0.999f);
}

/// `c`: cosine of the deflection, 1 straight on.
float phase(float g, float c) {
    const float k = schlick_k(g), d = 1 - k * c;
    return 0.25f * kInvPi * (1 - k * k) / (d * d);
}

/// Cosine of the deflection with density phase(g, c).
float sample_deflection(float g, float u) {
    const float k = schlick_k(g);
    return std::clamp((2 * u + k - 1) / (2 * k * u - k + 1), -1.0f, 1.0f);
}

}  // namespace

Rgb PhaseBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const {
    if (!(mask & kDiffuse) || wo.dot(ng_) * wi.dot(ng_) == 0) return Rgb(0.0f);
    // Light comes along wi for radiance and along wo for power; f is over its projected angle.
    const Vec3& light = transport == Transport::Radiance ? wi : wo;
    const float cosine = std::max(std::abs(light.dot(ns_)), kMinPhaseCosine);
    const float c = -wo.dot(wi);
    return kd_ * Rgb(phase(g_.x, c), phase(g_.y, c), phase(g_.z, c)) / cosine;
}

float PhaseBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & kDiffuse) || wo.dot(ng_) * wi.dot(ng_) == 0) return 0;
    const float c = -wo.dot(wi);
    return (phase(g_.x, c) + phase(g_.y, c) + phase(g_.z, c)) / 3;
}

bool PhaseBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                       LobeMask mask, BsdfSample& sample) const {
    if (!(mask & kDiffuse)) return false;
    const int channel = std::min(static_cast<int>(u_lobe * 3), 2);
    const float c = sample_deflection(g_[channel], u.x), phi = 2 * kPi * u.y;
    const float s = std::sqrt(std::max(0.0f, 1 - c * c));
    const Vec3 wi = Frame(-wo).to_world({s * std::cos(phi), s * std::sin(phi), c}).normalized();
    const float density = pdf(wo, wi, mask);
    if (!(density > 0)) return false;
    const Rgb f = evaluate(wo, wi, transport, mask);
    const bool transmitted = wo.dot(ng_) * wi.dot(ng_) < 0;
    sample = {wi, f * (std::abs(wi.dot(ns_)) / density), density, kDiffuse, transmitted, false};
    return true;
}

}  // namespace lxs::shading
