// Rough diffuse reflection: sampling and values.
#include "oren_nayar_bsdf.h"

namespace lxs::shading {

Rgb OrenNayarBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    if (!(mask & kDiffuse) || !same_side(wo, wi, ng_)) return Rgb(0.0f);
    return kd_ * (kInvPi * shape_(wo, wi, ns_));
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
    sample = {wi, kd_ * shape_(wo, wi, ns_), pdf, kDiffuse, false, false};
    return true;
}

Rgb OrenNayarBsdf::albedo(const Vec3& /*wo*/, LobeMask mask) const {
    return mask & kDiffuse ? kd_ * shape_.mean() : Rgb(0.0f);
}

}  // namespace lxs::shading
