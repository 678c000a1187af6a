// Diffuse base under a rough coating.
#include "glossy_bsdf.h"

#include <algorithm>

#include "channels.h"
#include "directions.h"

namespace lxs::shading {
namespace {

/// Cosine between a direction and the half vector of the pair.
float half_cosine(const Vec3& wo, const Vec3& wi) {
    return std::sqrt(std::max(0.0f, 0.5f * (1 + wo.dot(wi))));
}

}  // namespace

Rgb Coating::transmittance(float cosine) const {
    return absorbed(optical_depth, 1 / std::max(cosine, kMinCosine));
}

float GlossyBsdf::dielectric_reflectance() const {
    constexpr float kMost = 0.7f;  // of what DielectricRise has
    return std::min(max_component(coating_.reflectance), kMost);
}

Rgb GlossyBsdf::fresnel(float cosine) const {
    const Rgb& r0 = coating_.reflectance;
    if (!coating_.dielectric) return fresnel_schlick(cosine, r0);
    return r0 + (Rgb(1.0f) - r0) * DielectricRise::rise(cosine, dielectric_reflectance());
}

Rgb GlossyBsdf::bounce_color() const {
    constexpr float kMeanOfGrazing = 1.0f / 21;  // cosine-weighted mean of (1 - cos)^5
    const float rise = coating_.dielectric ? DielectricRise::table().mean(dielectric_reflectance())
                                           : kMeanOfGrazing;
    const Rgb mean = coating_.reflectance + (Rgb(1.0f) - coating_.reflectance) * rise;
    if (!coating_.conserving) return mean;
    // Kulla & Conty 2017, slide 14: what goes on between facets meets the Fresnel term each time.
    const float kept = MicrofacetAlbedo::table().average(facets_.roughness());
    return mean * mean * kept / (Rgb(1.0f) - mean * (1 - kept));
}

/// Cosine-weighted mean of the coating's albedo over the hemisphere.
Rgb GlossyBsdf::mean_coat() const {
    constexpr float kMost = 0.9999f;
    const float kept = MicrofacetAlbedo::table().average(facets_.roughness());
    const float rise =
        coating_.dielectric
            ? DielectricRise::table().average(facets_.roughness(), dielectric_reflectance())
            : MicrofacetAlbedo::table().average_grazing(facets_.roughness());
    const Rgb& r0 = coating_.reflectance;
    return min_of(r0 * kept + (Rgb(1.0f) - r0) * rise + bounce_color() * (1 - kept), Rgb(kMost));
}

GlossyBsdf::Side GlossyBsdf::side(const Vec3& w) const {
    const float cosine = std::abs(w.dot(facets_.ns()));
    const MicrofacetAlbedo::Entry facets =
        MicrofacetAlbedo::table().at(cosine, facets_.roughness());
    const Rgb& r0 = coating_.reflectance;
    const float rise = coating_.dielectric ? DielectricRise::table().at(cosine, facets_.roughness(),
                                                                        dielectric_reflectance())
                                           : facets.grazing;
    Rgb coat = r0 * facets.constant + (Rgb(1.0f) - r0) * rise;
    if (coating_.multibounce) coat += bounce_color() * (1 - facets.constant);
    return {cosine, facets, min_of(coat, Rgb(1.0f))};
}

Rgb GlossyBsdf::base(const Side& o, const Side& i, const Rgb& fresnel, float shape) const {
    const Rgb white(1.0f);
    if (coating_.conserving) {
        return kd_ * (white - o.coat) * (white - i.coat) / (white - mean_coat()) *
               (kInvPi * shape) * coating_.transmittance(o.cosine) *
               coating_.transmittance(i.cosine);
    }
    const Rgb f =
        min_of(kd_ * (white - fresnel), min_of(white - o.coat, white - i.coat)) * (kInvPi * shape);
    return f * coating_.transmittance(o.cosine) * coating_.transmittance(i.cosine);
}

Rgb GlossyBsdf::coat_diffuse(const Side& o, const Side& i) const {
    const float lost = 1 - MicrofacetAlbedo::table().average(facets_.roughness());
    if (!(lost > 1e-6f)) return Rgb(0.0f);
    // Kulla & Conty 2017, slide 13: albedo 1 - E(cos_o).
    const float f = (1 - o.facets.constant) * (1 - i.facets.constant) * kInvPi / lost;
    return bounce_color() * f;
}

Rgb GlossyBsdf::base_albedo(const Side& o) const {
    if (coating_.conserving) return kd_ * (Rgb(1.0f) - o.coat) * shape_.mean();
    return min_of(kd_ * (Rgb(1.0f) - coating_.reflectance), Rgb(1.0f) - o.coat) * shape_.mean();
}

Rgb GlossyBsdf::back_value(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & kDiffuse) || black_base_) return Rgb(0.0f);
    const Vec3& ns = facets_.ns();
    const Rgb f = kd_ * (kInvPi * shape_(wo, wi, ns));
    if (back_ == CoatedBack::Bare) return f;
    return f * (Rgb(1.0f) - fresnel_schlick(half_cosine(wo, wi), coating_.reflectance)) *
           coating_.transmittance(std::abs(wo.dot(ns))) *
           coating_.transmittance(std::abs(wi.dot(ns)));
}

bool GlossyBsdf::sample_back(const Vec3& wo, const Vec2& u, LobeMask mask,
                             BsdfSample& sample) const {
    Vec3 wi;
    if (!(mask & kDiffuse) || black_base_ || !sample_cosine(wo, facets_.ng(), facets_.ns(), u, wi))
        return false;
    const float pdf = std::abs(wi.dot(facets_.ns())) * kInvPi;
    sample = {wi, back_value(wo, wi, mask) * kPi, pdf, kDiffuse, false, false};
    return true;
}

GlossyBsdf::Choice GlossyBsdf::choose(const Side& o, LobeMask mask) const {
    Choice choice;
    const float coat = mask & kGlossy ? max_component(o.coat) : 0.0f;
    const float base = mask & kDiffuse ? max_component(base_albedo(o)) : 0.0f;
    const bool can_coat = mask & kGlossy, can_base = (mask & kDiffuse) && !black_base_;
    float p_coat = coat + base > 0 ? coat / (coat + base) : 0.5f;
    // Both parts keep a share: their estimates are means over channels and directions.
    p_coat = !can_base ? 1.0f : !can_coat ? 0.0f : std::clamp(p_coat, 0.1f, 0.9f);
    const float p_facets = coating_.multibounce ? std::max(0.25f, o.facets.constant) : 1.0f;
    choice.facets = p_coat * p_facets;
    choice.coat_diffuse = p_coat - choice.facets;
    choice.base = 1 - p_coat;
    return choice;
}

float GlossyBsdf::density(const Choice& choice, const HalfVector* half, float cos_i) const {
    const float diffuse = (choice.coat_diffuse + choice.base) * cos_i * kInvPi;
    return half && choice.facets > 0 ? diffuse + choice.facets * facets_.pdf(*half) : diffuse;
}

Rgb GlossyBsdf::value(const Vec3& wo, const Vec3& wi, const Side& o, const Side& i,
                      const HalfVector* half, LobeMask mask) const {
    const Rgb reflected = fresnel(half_cosine(wo, wi));
    Rgb sum(0.0f);
    if ((mask & kDiffuse) && !black_base_)
        sum += base(o, i, reflected, shape_(wo, wi, facets_.ns()));
    if (mask & kGlossy) {
        if (half) sum += reflected * facets_.value(*half);
        if (coating_.multibounce) sum += coat_diffuse(o, i);
    }
    return sum;
}

Rgb GlossyBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return Rgb(0.0f);
    if (behind(wo)) return back_value(wo, wi, mask);
    HalfVector half;
    const bool seen = facets_.half_vector(wo, wi, half);
    return value(wo, wi, side(wo), side(wi), seen ? &half : nullptr, mask);
}

float GlossyBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return 0;
    if (behind(wo)) {
        return (mask & kDiffuse) && !black_base_ ? std::abs(wi.dot(facets_.ns())) * kInvPi : 0.0f;
    }
    HalfVector half;
    const bool seen = facets_.half_vector(wo, wi, half);
    return density(choose(side(wo), mask), seen ? &half : nullptr, std::abs(wi.dot(facets_.ns())));
}

bool GlossyBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                        BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    if (behind(wo)) return sample_back(wo, u, mask, sample);
    const Side o = side(wo);
    const Choice choice = choose(o, mask);
    Vec3 wi;
    HalfVector half;
    if (u_lobe < choice.facets) {
        const float rest = clamp_to_unit(u_lobe / choice.facets);
        if (!facets_.sample(wo, u, rest, wi, half)) return false;
    } else if (!sample_cosine(wo, facets_.ng(), facets_.ns(), u, wi)) {
        return false;
    }
    const bool seen = facets_.half_vector(wo, wi, half);
    const HalfVector* pair = seen ? &half : nullptr;
    const Side i = side(wi);
    const float pdf = density(choice, pair, i.cosine);
    if (!(pdf > 0)) return false;
    const Rgb f = value(wo, wi, o, i, pair, mask);
    const bool coat = u_lobe < choice.facets + choice.coat_diffuse;
    sample = {wi, f * (i.cosine / pdf), pdf, coat ? kGlossy : kDiffuse, false, false};
    return true;
}

Rgb GlossyBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (behind(wo)) return mask & kDiffuse ? kd_ * shape_.mean() : Rgb(0.0f);
    const Side o = side(wo);
    Rgb sum(0.0f);
    if (mask & kGlossy) sum += o.coat;
    if (mask & kDiffuse) sum += base_albedo(o);
    return sum;
}

}  // namespace lxs::shading
