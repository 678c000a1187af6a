// Any Bsdf under a rough coating.
#include "coated_bsdf.h"

#include <algorithm>
#include <cmath>

#include "channels.h"

#include "directions.h"

namespace lxs::shading {
namespace {

/// Root of what a coating lets in under the cosine `u` of a half angle.
Rgb half_of_coating(const Coating& coating, float u) {
    const Rgb through = Rgb(1.0f) - fresnel_schlick(u, coating.reflectance);
    return {std::sqrt(through.x), std::sqrt(through.y), std::sqrt(through.z)};
}

/// Both ways' lengths in units of the coating's depth.
float crossings(float cos_o, float cos_i) {
    return 1 / std::max(std::abs(cos_o), kMinCosine) + 1 / std::max(std::abs(cos_i), kMinCosine);
}

}  // namespace

Rgb coating_transmission(const Coating& coating, float c) {
    return half_of_coating(coating, std::abs(c)) * absorbed(coating.optical_depth, crossings(c, c));
}

Rgb CoatedBsdf::crossing(const Vec3& w) const {
    if (w.dot(ng_) < 0) return Rgb(1.0f);
    const float cosine = std::abs(w.dot(ns_));
    return (Rgb(1.0f) - fresnel_schlick(cosine, coating_.reflectance)) *
           coating_.transmittance(cosine);
}

Rgb CoatedBsdf::passed(const Vec3& wo, const Vec3& wi) const {
    const float cos_o = wo.dot(ns_), cos_i = wi.dot(ns_);
    if (!same_side(wo, wi, ng_)) {
        // Half angle between wo and the mirror image of wi.
        const float u = std::sqrt(std::max(0.0f, 0.5f * (1 + wo.dot(wi) - 2 * cos_o * cos_i)));
        return half_of_coating(coating_, std::min(u, 1.0f)) *
               absorbed(coating_.optical_depth, crossings(cos_o, cos_i));
    }
    if (wo.dot(ng_) < 0) return Rgb(1.0f);
    const float half_cosine = std::sqrt(std::max(0.0f, 0.5f * (1 + wo.dot(wi))));
    const Rgb through = Rgb(1.0f) - fresnel_schlick(half_cosine, coating_.reflectance);
    // As in GlossyBsdf: no more than the coating leaves over on the way in and on the way out.
    const Rgb coat_o = coat_.albedo(wo, kGlossy), coat_i = coat_.albedo(wi, kGlossy);
    const Rgb base_o = base_->albedo(wo, kAllLobes), base_i = base_->albedo(wi, kAllLobes);
    Rgb share = absorbed(coating_.optical_depth, crossings(cos_o, cos_i));
    for (int c = 0; c < 3; ++c) {
        const float left = 1 - std::max(coat_o[c], coat_i[c]);
        const float base = std::max({base_o[c], base_i[c], kMinCosine});
        share[c] *= std::min(through[c], left / base);
    }
    return share;
}

float CoatedBsdf::p_coat(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kGlossy)) return 0;
    if (!base_takes_part(mask)) return 1;
    if (wo.dot(ng_) < 0) return 0;
    const float coat = max_component(coat_.albedo(wo, kGlossy));
    const float base = max_component(base_->albedo(wo, mask) * crossing(wo));
    return coat + base > 0 ? std::clamp(coat / (coat + base), 0.1f, 0.9f) : 0.5f;
}

Rgb CoatedBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kGlossy) sum += coat_.evaluate(wo, wi, transport, kGlossy);
    if (!base_takes_part(mask)) return sum;
    const Rgb base = base_->evaluate(wo, wi, transport, mask);
    return is_black(base) ? sum : sum + base * passed(wo, wi);
}

float CoatedBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const float p = p_coat(wo, mask);
    float sum = 0;
    if (p > 0) sum += p * coat_.pdf(wo, wi, kGlossy);
    if (base_takes_part(mask)) sum += (1 - p) * base_->pdf(wo, wi, mask);
    return sum;
}

bool CoatedBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                        LobeMask mask, BsdfSample& sample) const {
    const float p = p_coat(wo, mask);
    if (u_lobe < p) {
        if (!coat_.sample(wo, u, u_lobe / p, transport, kGlossy, sample)) return false;
    } else {
        if (!base_takes_part(mask)) return false;
        const float rest = clamp_to_unit((u_lobe - p) / (1 - p));
        if (!base_->sample(wo, u, rest, transport, mask, sample)) return false;
        if (sample.lobe == kSpecular) {
            sample.weight *= passed(wo, sample.wi) / (1 - p);
            return true;
        }
    }
    sample.pdf = pdf(wo, sample.wi, mask);
    if (!(sample.pdf > 0)) return false;
    const float cosine = std::abs(sample.wi.dot(ns_));
    sample.weight = evaluate(wo, sample.wi, transport, mask) * (cosine / sample.pdf);
    return true;
}

Rgb CoatedBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kGlossy) sum += coat_.albedo(wo, kGlossy);
    if (base_takes_part(mask)) sum += base_->albedo(wo, mask) * crossing(wo);
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
