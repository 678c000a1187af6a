// Rough diffuse reflection (Oren & Nayar 1994, equation 30).
#include "oren_nayar_bsdf.h"

#include <algorithm>

namespace lxs::shading {
namespace {

/// Keeps f finite where both directions graze the surface; f * cos stays bounded anyway.
constexpr float kMinCosine = 1e-6f;

}  // namespace

OrenNayarBsdf::OrenNayarBsdf(const Rgb& kd, float sigma, const Vec3& ng, const Vec3& ns)
    : kd_(kd), ng_(ng), ns_(ns) {
    const float sigma2 = sigma * sigma;
    a_ = 1 - sigma2 / (2 * (sigma2 + 0.33f));
    b_ = 0.45f * sigma2 / (sigma2 + 0.09f);
}

float OrenNayarBsdf::shape(const Vec3& wo, const Vec3& wi) const {
    const float cos_o = wo.dot(ns_), cos_i = wi.dot(ns_);
    // sin(alpha) tan(beta) cos(phi_i - phi_o) without an angle: the tangential parts' product over
    // the larger cosine.
    const float tangential = std::max(0.0f, wo.dot(wi) - cos_o * cos_i);
    const float larger = std::max({std::abs(cos_o), std::abs(cos_i), kMinCosine});
    return a_ + b_ * tangential / larger;
}

Rgb OrenNayarBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    if (!(mask & kDiffuse) || !same_side(wo, wi, ng_)) return Rgb(0.0f);
    return kd_ * (kInvPi * shape(wo, wi));
}

float OrenNayarBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & kDiffuse) || !same_side(wo, wi, ng_)) return 0;
    return std::abs(wi.dot(ns_)) * kInvPi;
}

bool OrenNayarBsdf::sample(const Vec3& wo, const Vec2& u, float /*u_lobe*/, Transport,
                           LobeMask mask, BsdfSample& sample) const {
    Vec3 wi;
    if (!(mask & kDiffuse) || !sample_cosine(wo, ng_, ns_, u, wi)) return false;
    const float pdf = std::abs(wi.dot(ns_)) * kInvPi;
    sample = {wi, kd_ * shape(wo, wi), pdf, kDiffuse, false, false};
    return true;
}

Rgb OrenNayarBsdf::albedo(const Vec3& /*wo*/, LobeMask mask) const {
    // The second term adds between 0 and about half of b; its middle is near enough.
    return mask & kDiffuse ? kd_ * std::min(1.0f, a_ + 0.25f * b_) : Rgb(0.0f);
}

}  // namespace lxs::shading
