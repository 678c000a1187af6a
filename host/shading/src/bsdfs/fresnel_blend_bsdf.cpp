// A diffuse base and a coating that shade off into each other.
#include "fresnel_blend_bsdf.h"

#include <algorithm>
#include <cmath>

#include "channels.h"
#include "directions.h"

namespace lxs::shading {
namespace {

/// 1 - (1 - c / 2)^5.
float shade(float c) {
    const float m = 1 - 0.5f * c;
    return 1 - m * m * m * m * m;
}

}  // namespace

FresnelBlendBsdf::FresnelBlendBsdf(const Rgb& kd, const Coating& coating,
                                   const MicrofacetLobe& facets)
    : kd_(kd), coating_(coating), facets_(facets) {}

Rgb FresnelBlendBsdf::base(float cos_o, float cos_i) const {
    const Rgb f =
        kd_ * (Rgb(1.0f) - coating_.reflectance) * (28 * kInvPi / 23 * shade(cos_o) * shade(cos_i));
    const float crossings = 1 / std::max(cos_o, kMinCosine) + 1 / std::max(cos_i, kMinCosine);
    return f * absorbed(coating_.optical_depth, crossings);
}

Rgb FresnelBlendBsdf::coat(const HalfVector& half) const {
    const float d = facets_.density(half.h);
    return fresnel_schlick(half.cosine, coating_.reflectance) *
           (d / (4 * half.cosine * std::max(half.wo.z, half.wi.z)));
}

float FresnelBlendBsdf::p_coat(LobeMask mask) const {
    if (!(mask & kDiffuse)) return 1;
    if (!(mask & kGlossy)) return 0;
    const float coat = max_component(coating_.reflectance), base = max_component(kd_);
    return coat + base > 0 ? std::clamp(coat / (coat + base), 0.2f, 0.8f) : 0.5f;
}

Rgb FresnelBlendBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return Rgb(0.0f);
    Rgb sum(0.0f);
    if (mask & kDiffuse)
        sum += base(std::abs(wo.dot(facets_.ns())), std::abs(wi.dot(facets_.ns())));
    HalfVector half;
    if ((mask & kGlossy) && facets_.half_vector(wo, wi, half)) sum += coat(half);
    return sum;
}

float FresnelBlendBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return 0;
    const float p = p_coat(mask);
    HalfVector half;
    float sum = (1 - p) * std::abs(wi.dot(facets_.ns())) * kInvPi;
    if (p > 0 && facets_.half_vector(wo, wi, half)) sum += p * facets_.pdf(half);
    return sum;
}

bool FresnelBlendBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                              LobeMask mask, BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    const float p = p_coat(mask);
    const bool coat = u_lobe < p;
    Vec3 wi;
    HalfVector half;
    if (coat) {
        if (!facets_.sample(wo, u, clamp_to_unit(u_lobe / p), wi, half)) return false;
    } else if (!sample_cosine(wo, facets_.ng(), facets_.ns(), u, wi)) {
        return false;
    }
    const float density = pdf(wo, wi, mask);
    if (!(density > 0)) return false;
    const float cosine = std::abs(wi.dot(facets_.ns()));
    sample = {wi,      evaluate(wo, wi, transport, mask) * (cosine / density),
              density, coat ? kGlossy : kDiffuse,
              false,   false};
    return true;
}

Rgb FresnelBlendBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    const float cosine = std::abs(wo.dot(facets_.ns()));
    Rgb sum(0.0f);
    if (mask & kGlossy) sum += fresnel_schlick(cosine, coating_.reflectance);
    if (mask & kDiffuse) sum += kd_ * (Rgb(1.0f) - coating_.reflectance) * shade(cosine);
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
