// Diffuse reflection and transmission: sampling and values.
#include "translucent_bsdf.h"

namespace lxs::shading {

Rgb TranslucentBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    const float sides = wo.dot(ng_) * wi.dot(ng_);
    if (!(mask & kDiffuse) || sides == 0) return Rgb(0.0f);
    return (sides > 0 ? kr_ : kt_) * (kInvPi * shape_(wo, wi, ns_));
}

float TranslucentBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const float sides = wo.dot(ng_) * wi.dot(ng_);
    if (!(mask & kDiffuse) || sides == 0) return 0;
    const float p = p_reflect();
    return (sides > 0 ? p : 1 - p) * std::abs(wi.dot(ns_)) * kInvPi;
}

bool TranslucentBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                             BsdfSample& sample) const {
    Vec3 wi;
    if (!(mask & kDiffuse) || !sample_cosine(wo, ng_, ns_, u, wi)) return false;
    const float p = p_reflect();
    const bool transmitted = u_lobe >= p;
    // The opposites of directions that fill one side fill the other with the same density.
    if (transmitted) wi = -wi;
    const float p_side = transmitted ? 1 - p : p;
    const Rgb color = (transmitted ? kt_ : kr_) * (shape_(wo, wi, ns_) / p_side);
    sample = {wi, color, p_side * std::abs(wi.dot(ns_)) * kInvPi, kDiffuse, transmitted, false};
    return true;
}

Rgb TranslucentBsdf::albedo(const Vec3& /*wo*/, LobeMask mask) const {
    if (!(mask & kDiffuse)) return Rgb(0.0f);
    const Rgb sum = (kr_ + kt_) * shape_.mean();
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
