// Polished metal: a rough and a mirror-like reflection added up.
#include "shiny_metal_bsdf.h"

#include <algorithm>

namespace lxs::shading {

Rgb ShinyMetalBsdf::smooth_reflectance(const Vec3& wo) const {
    const float cosine = std::abs(wo.dot(facets_.ns()));
    const Rgb left = Rgb(1.0f) - rough_albedo(cosine);
    const Rgb smooth = fresnel_conductor(cosine, smooth_) * film_.filter(cosine);
    return {std::min(smooth.x, left.x), std::min(smooth.y, left.y), std::min(smooth.z, left.z)};
}

Rgb ShinyMetalBsdf::rough_albedo(float cosine) const {
    const auto facets = MicrofacetAlbedo::table().at(cosine, facets_.roughness());
    const Rgb r0 = fresnel_conductor(1, rough_);
    return r0 * facets.constant + (Rgb(1.0f) - r0) * facets.grazing;
}

float ShinyMetalBsdf::p_rough(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kSpecular)) return 1;
    if (!(mask & kGlossy)) return 0;
    const float rough = max_component(rough_albedo(std::abs(wo.dot(facets_.ns()))));
    const float smooth = max_component(smooth_reflectance(wo));
    return rough + smooth > 0 ? rough / (rough + smooth) : 0.5f;
}

Rgb ShinyMetalBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    HalfVector half;
    if (!(mask & kGlossy) || !facets_.half_vector(wo, wi, half)) return Rgb(0.0f);
    return fresnel_conductor(half.cosine, rough_) * facets_.value(half);
}

float ShinyMetalBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    HalfVector half;
    if (!(mask & kGlossy) || !facets_.half_vector(wo, wi, half)) return 0;
    return facets_.pdf(half) * p_rough(wo, mask);
}

bool ShinyMetalBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                            BsdfSample& sample) const {
    if (!(mask & (kGlossy | kSpecular))) return false;
    const float p = p_rough(wo, mask);
    if (u_lobe >= p) {
        const Vec3 wi = reflect(wo, facets_.ns());
        sample = {wi, smooth_reflectance(wo) / (1 - p), 0, kSpecular, false, false};
        return same_side(wo, wi, facets_.ng());
    }
    HalfVector half;
    Vec3 wi;
    if (!facets_.sample(wo, u, u_lobe / p, wi, half)) return false;
    const float pdf = facets_.pdf(half) * p;
    if (!(pdf > 0)) return false;
    const Rgb f = fresnel_conductor(half.cosine, rough_) * facets_.value(half);
    sample = {wi, f * (half.wi.z / pdf), pdf, kGlossy, false, false};
    return true;
}

Rgb ShinyMetalBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kGlossy) sum += rough_albedo(std::abs(wo.dot(facets_.ns())));
    if (mask & kSpecular) sum += smooth_reflectance(wo);
    return sum;
}

}  // namespace lxs::shading
