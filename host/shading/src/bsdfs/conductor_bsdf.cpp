// Rough metal: microfacets with the exact Fresnel term.
#include "conductor_bsdf.h"

namespace lxs::shading {

Rgb ConductorBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    HalfVector half;
    if (!(mask & kGlossy) || !facets_.half_vector(wo, wi, half)) return Rgb(0.0f);
    return fresnel_conductor(half.cosine, fresnel_) * facets_.value(half);
}

float ConductorBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    HalfVector half;
    if (!(mask & kGlossy) || !facets_.half_vector(wo, wi, half)) return 0;
    return facets_.pdf(half);
}

bool ConductorBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                           BsdfSample& sample) const {
    HalfVector half;
    Vec3 wi;
    if (!(mask & kGlossy) || !facets_.sample(wo, u, u_lobe, wi, half)) return false;
    const float pdf = facets_.pdf(half);
    if (!(pdf > 0)) return false;
    const Rgb f = fresnel_conductor(half.cosine, fresnel_) * facets_.value(half);
    sample = {wi, f * (half.wi.z / pdf), pdf, kGlossy, false, false};
    return true;
}

Rgb ConductorBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kGlossy)) return Rgb(0.0f);
    return fresnel_conductor(std::abs(wo.dot(facets_.ns())), fresnel_);
}

}  // namespace lxs::shading
