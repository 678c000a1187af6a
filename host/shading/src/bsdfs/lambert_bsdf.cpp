// Ideal diffuse reflection: sampling.
#include "lambert_bsdf.h"

namespace lxs::shading {

bool LambertBsdf::sample(const Vec3& wo, const Vec2& u, float /*u_lobe*/, Transport, LobeMask mask,
                         BsdfSample& sample) const {
    if (!(mask & kDiffuse)) return false;
    Vec3 wi;
    if (!sample_cosine(wo, ng_, ns_, u, wi)) return false;
    sample = {wi, kd_, std::abs(wi.dot(ns_)) * kInvPi, kDiffuse, false, false};
    return true;
}

}  // namespace lxs::shading
