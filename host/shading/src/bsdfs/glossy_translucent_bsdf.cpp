// Translucent sheet under rough coatings: sampling and values.
#include "glossy_translucent_bsdf.h"

#include <algorithm>

#include "channels.h"

namespace lxs::shading {
namespace {}  // namespace

Rgb GlossyTranslucentBsdf::transmission(const Vec3& wo, const Vec3& wi) const {
    const GlossyBsdf &side_o = side_of(wo), &side_i = side_of(wi);
    const float cos_o = wo.dot(ns_), cos_i = wi.dot(ns_);
    // Half angle between wo and the mirror image of wi.
    const float half = std::sqrt(std::max(0.0f, 0.5f * (1 + wo.dot(wi) - 2 * cos_o * cos_i)));
    const Rgb white(1.0f);
    const Rgb past_o = white - fresnel_schlick(half, side_o.coating().reflectance);
    const Rgb past_i = white - fresnel_schlick(half, side_i.coating().reflectance);
    const Rgb left = min_of(white - side_o.coat_albedo(wo), white - side_i.coat_albedo(wi));
    Rgb f(0.0f);
    for (int c = 0; c < 3; ++c) {
        const float past = std::sqrt(past_o[c] * past_i[c]);
        // Never more than the coatings and the reflecting base leave over.
        const float limit = left[c] - std::min(left[c], kd_[c] * past);
        f[c] = std::min(kt_[c] * (1 - kd_[c]) * past, limit) * kInvPi;
    }
    return f * side_o.coating().transmittance(std::abs(cos_o)) *
           side_i.coating().transmittance(std::abs(cos_i));
}

Rgb GlossyTranslucentBsdf::transmitted_albedo(const Vec3& wo) const {
    const Rgb white(1.0f);
    return kt_ * (white - kd_) * (white - side_of(wo).coat_albedo(wo));
}

float GlossyTranslucentBsdf::p_transmit(const Vec3& wo, LobeMask mask) const {
    if (!transmits(mask)) return 0;
    const GlossyBsdf& side = side_of(wo);
    if (!(side.lobes() & mask)) return 1;
    const float transmitted = max_component(transmitted_albedo(wo));
    const float reflected = max_component(side.albedo(wo, mask));
    const float sum = transmitted + reflected;
    return sum > 0 ? std::clamp(transmitted / sum, 0.1f, 0.9f) : 0.5f;
}

Rgb GlossyTranslucentBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                                    LobeMask mask) const {
    const float sides = wo.dot(ng_) * wi.dot(ng_);
    if (sides > 0) return side_of(wo).evaluate(wo, wi, transport, mask);
    return sides < 0 && transmits(mask) ? transmission(wo, wi) : Rgb(0.0f);
}

float GlossyTranslucentBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const float sides = wo.dot(ng_) * wi.dot(ng_), p = p_transmit(wo, mask);
    if (sides > 0) return (1 - p) * side_of(wo).pdf(wo, wi, mask);
    return sides < 0 ? p * std::abs(wi.dot(ns_)) * kInvPi : 0.0f;
}

bool GlossyTranslucentBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                                   LobeMask mask, BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    const float p = p_transmit(wo, mask);
    if (u_lobe >= p) {
        const float rest = clamp_to_unit((u_lobe - p) / (1 - p));
        if (!side_of(wo).sample(wo, u, rest, transport, mask, sample)) return false;
        sample.weight *= 1 / (1 - p);
        sample.pdf *= 1 - p;
        return true;
    }
    Vec3 opposite;
    if (!sample_cosine(wo, ng_, ns_, u, opposite)) return false;
    const Vec3 wi = -opposite;
    const float pdf = p * std::abs(wi.dot(ns_)) * kInvPi;
    sample = {wi, transmission(wo, wi) * (kPi / p), pdf, kDiffuse, true, false};
    return true;
}

Rgb GlossyTranslucentBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    const GlossyBsdf& side = side_of(wo);
    Rgb sum = side.albedo(wo, mask);
    if (transmits(mask)) sum += transmitted_albedo(wo);
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
