// Reflection by a surface of microfacets.
#include "microfacet_lobe.h"

#include <algorithm>

namespace lxs::shading {

float local_above(const Frame& frame, const Vec3& ng, const Vec3& wo, Vec3& local) {
    const float side = wo.dot(ng) < 0 ? -1.0f : 1.0f;
    local = frame.to_local(wo);
    local.z *= side;
    return local.z > 0 ? side : 0.0f;
}

bool reflecting_half_vector(const Frame& frame, const Vec3& ng, const Vec3& wo, const Vec3& wi,
                            HalfVector& half) {
    const float side = wo.dot(ng);
    if (!(side * wi.dot(ng) > 0)) return false;
    half.wo = frame.to_local(wo);
    half.wi = frame.to_local(wi);
    if (side < 0) {
        half.wo.z = -half.wo.z;
        half.wi.z = -half.wi.z;
    }
    if (!(half.wo.z > 0) || !(half.wi.z > 0)) return false;
    half.h = (half.wo + half.wi).normalized();
    half.cosine = half.wo.dot(half.h);
    return half.cosine > 0 && half.h.z > 0;
}

Vec3 visible_wall(const Vec3& wo, const Vec3& h, float& u_choice) {
    const Vec3 other(-h.x, -h.y, h.z);
    const float seen = std::max(0.0f, wo.dot(h)), seen_other = std::max(0.0f, wo.dot(other));
    const float p = seen + seen_other > 0 ? seen / (seen + seen_other) : 1.0f;
    if (u_choice < p) {
        u_choice = clamp_to_unit(u_choice / p);
        return h;
    }
    u_choice = clamp_to_unit((u_choice - p) / (1 - p));
    return other;
}

bool MicrofacetLobe::half_vector(const Vec3& wo, const Vec3& wi, HalfVector& half) const {
    return reflecting_half_vector(frame_, ng_, wo, wi, half);
}

namespace {

float shadowing_of(const SchlickDistribution& facets, const Vec3& wo, const Vec3& wi) {
    const float cos_o = std::abs(wo.z), cos_i = std::abs(wi.z);
    const float schlick = facets.shadowing_over_cosine(cos_o) * facets.shadowing_over_cosine(cos_i);
    // Dividing by the larger of both bounds keeps f reciprocal and its albedo at most 1.
    const float bound = std::max(facets.reflected_bound(cos_o), facets.reflected_bound(cos_i));
    return schlick / std::max(1.0f, bound);
}

float shadowing_of(const TrowbridgeReitz& facets, const Vec3& wo, const Vec3& wi) {
    return facets.shadowing_over_cosines(wo, wi);
}

}  // namespace

float MicrofacetLobe::shadowing(const Vec3& wo, const Vec3& wi) const {
    return std::visit([&](const auto& facets) { return shadowing_of(facets, wo, wi); },
                      distribution_);
}

float MicrofacetLobe::value(const HalfVector& half) const {
    return 0.25f * density(half.h) * shadowing(half.wo, half.wi);
}

float MicrofacetLobe::facet_pdf(const Vec3& wo, const Vec3& h, float cosine) const {
    if (const auto* smith = std::get_if<TrowbridgeReitz>(&distribution_))
        return smith->visible_density(wo, h);
    // Visible facets of V-cavities: D min(1, 2 h.z cos_o / (wo.h)) / cos_o.
    const float masking_over_cosine = std::min(1 / wo.z, 2 * h.z / cosine);
    return density(h) * masking_over_cosine;
}

float MicrofacetLobe::pdf(const HalfVector& half) const {
    return 0.25f * facet_pdf(half.wo, half.h, half.cosine);
}

Vec3 MicrofacetLobe::sample_facet(const Vec3& wo, const Vec2& u, float& u_choice) const {
    if (const auto* schlick = std::get_if<SchlickDistribution>(&distribution_))
        return visible_wall(wo, schlick->sample(u), u_choice);
    return std::get<TrowbridgeReitz>(distribution_).sample_visible(wo, u);
}

bool MicrofacetLobe::sample(const Vec3& wo, const Vec2& u, float u_choice, Vec3& wi,
                            HalfVector& half) const {
    Vec3 local;
    const float side = local_above(frame_, ng_, wo, local);
    if (side == 0) return false;
    Vec3 reflected = reflect(local, sample_facet(local, u, u_choice));
    if (!(reflected.z > 0)) return false;
    reflected.z *= side;
    wi = frame_.to_world(reflected).normalized();
    return half_vector(wo, wi, half);
}

}  // namespace lxs::shading
