// Single scattering in a thin layer of fibres: sampling and values.
#include "asperity_bsdf.h"

#include <algorithm>

namespace lxs::shading {
namespace {

constexpr float kSheerCosine = 1e-4f;
constexpr float kUniform = 0.5f * kInvPi;  ///< density over a hemisphere

}  // namespace

Rgb AsperityBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                           LobeMask mask) const {
    if (!(mask & kDiffuse) || !same_side(wo, wi, ng_)) return Rgb(0.0f);
    const bool seen_from_wo = transport == Transport::Radiance;
    const Vec3& view = seen_from_wo ? wo : wi;
    const Vec3& light = seen_from_wo ? wi : wo;
    const float cos_view = std::max(std::abs(view.dot(ns_)), kSheerCosine);
    const float cos_light = std::max(std::abs(light.dot(ns_)), kSheerCosine);
    const float scattered = thickness_ * phase_(-wo.dot(wi)) * 0.25f * kInvPi / cos_view;
    return kd_ * (std::min(scattered, 1.0f) / cos_light);
}

float AsperityBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    return (mask & kDiffuse) && same_side(wo, wi, ng_) ? kUniform : 0.0f;
}

bool AsperityBsdf::sample(const Vec3& wo, const Vec2& u, float /*u_lobe*/, Transport transport,
                          LobeMask mask, BsdfSample& sample) const {
    // f cos_i knows no cosine of wi, so a uniform direction suits it.
    if (!(mask & kDiffuse) || wo.dot(ng_) == 0) return false;
    const float phi = 2 * kPi * u.y, r = std::sqrt(std::max(0.0f, 1 - u.x * u.x));
    Vec3 wi = Frame(ng_).to_world({r * std::cos(phi), r * std::sin(phi), u.x});
    if (wo.dot(ng_) < 0) wi = -wi;
    if (!same_side(wo, wi, ng_)) return false;
    const Rgb f = evaluate(wo, wi, transport, kDiffuse);
    sample = {wi, f * (std::abs(wi.dot(ns_)) / kUniform), kUniform, kDiffuse, false, false};
    return true;
}

Rgb AsperityBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kDiffuse)) return Rgb(0.0f);
    const float cosine = std::max(std::abs(wo.dot(ns_)), kSheerCosine);
    // A phase function's mean is 1 over the sphere; half of it leaves on wo's side.
    return kd_ * std::min(1.0f, 0.5f * thickness_ / cosine);
}

}  // namespace lxs::shading
