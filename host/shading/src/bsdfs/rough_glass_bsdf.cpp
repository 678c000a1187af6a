// Rough dielectric interface: sampling and values. Radiance is scaled by the squared index ratio at
// a refraction, power is not (Veach 1997, section 5.2).
#include "rough_glass_bsdf.h"

#include <algorithm>

#include "fresnel.h"

namespace lxs::shading {

bool RoughGlassBsdf::crossing(const Vec3& wo, const Vec3& wi, Crossing& c) const {
    const float side_o = wo.dot(facets_.ng()), side_i = wi.dot(facets_.ng());
    if (side_o == 0 || side_i == 0) return false;
    c.wo = facets_.frame().to_local(wo);
    c.wi = facets_.frame().to_local(wi);
    if (side_o < 0) {
        c.wo.z = -c.wo.z;
        c.wi.z = -c.wi.z;
    }
    const bool reflects = side_o * side_i > 0;
    if (!(c.wo.z > 0) || !(reflects ? c.wi.z > 0 : c.wi.z < 0)) return false;
    const float index_o = side_o > 0 ? 1.0f : eta_, index_i = side_i > 0 ? 1.0f : eta_;
    c.eta = side_o > 0 ? eta_ : 1 / eta_;
    // Walter et al., equations 13 and 16; both orders of the directions have the same bits.
    c.h = (c.wo * index_o + c.wi * index_i).normalized();
    if (c.h.z < 0) c.h = -c.h;
    c.cos_o = c.wo.dot(c.h);
    c.cos_i = c.wi.dot(c.h);
    if (!(c.h.z > 0) || !(c.cos_o > 0) || !(reflects ? c.cos_i > 0 : c.cos_i < 0)) return false;
    // Near the critical angle a rounding error would show; these have the same bits both ways.
    if (reflects)
        c.fresnel = fresnel_dielectric(0.5f * (c.cos_o + c.cos_i), c.eta);
    else if (c.eta > 1)
        c.fresnel = fresnel_dielectric(c.cos_o, c.eta);
    else
        c.fresnel = fresnel_dielectric(-c.cos_i, 1 / c.eta);
    return true;
}

float RoughGlassBsdf::p_reflect(float fresnel) const {
    const float reflected = max_component(kr_) * fresnel;
    const float refracted = max_component(kt_) * (1 - fresnel);
    return reflected + refracted > 0 ? reflected / (reflected + refracted) : 0.5f;
}

Rgb RoughGlassBsdf::value(const Crossing& c, Transport transport) const {
    const float facets = facets_.density(c.h) * facets_.shadowing(c.wo, c.wi);
    if (!c.refracts()) return kr_ * (0.25f * facets * c.fresnel);
    // Walter et al., equation 21.
    const float scale = transport == Transport::Radiance ? 1.0f : c.eta * c.eta;
    const float jacobian = c.cos_o * -c.cos_i / (c.length() * c.length());
    return kt_ * (facets * jacobian * scale * (1 - c.fresnel));
}

float RoughGlassBsdf::density(const Crossing& c) const {
    const float p = p_reflect(c.fresnel);
    const float facet = facets_.facet_pdf(c.wo, c.h, c.cos_o);
    if (!c.refracts()) return 0.25f * p * facet;
    // Walter et al., equation 17.
    return (1 - p) * facet * c.cos_o * c.eta * c.eta * -c.cos_i / (c.length() * c.length());
}

Rgb RoughGlassBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                             LobeMask mask) const {
    Crossing c;
    if (!(mask & kGlossy) || !crossing(wo, wi, c)) return Rgb(0.0f);
    return value(c, transport);
}

float RoughGlassBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    Crossing c;
    if (!(mask & kGlossy) || !crossing(wo, wi, c)) return 0;
    return density(c);
}

bool RoughGlassBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                            LobeMask mask, BsdfSample& sample) const {
    if (!(mask & kGlossy)) return false;
    const bool from_front = wo.dot(facets_.ng()) > 0;
    Vec3 local = facets_.frame().to_local(wo);
    if (!from_front) local.z = -local.z;
    if (!(local.z > 0)) return false;
    const Vec3 h = facets_.sample_facet(local, u, u_lobe);
    const float cos_o = local.dot(h), eta = from_front ? eta_ : 1 / eta_;
    if (!(cos_o > 0)) return false;
    const bool reflects = u_lobe < p_reflect(fresnel_dielectric(cos_o, eta));
    Vec3 wi = reflect(local, h);
    if (!reflects) {
        const float sin2_t = (1 - cos_o * cos_o) / (eta * eta);
        if (sin2_t >= 1) return false;
        wi = h * (cos_o / eta - std::sqrt(1 - sin2_t)) - local / eta;
    }
    if (!from_front) wi.z = -wi.z;
    wi = facets_.frame().to_world(wi).normalized();
    Crossing c;
    if (!crossing(wo, wi, c) || c.refracts() == reflects) return false;
    const float pdf = density(c);
    if (!(pdf > 0)) return false;
    sample = {wi, value(c, transport) * (std::abs(c.wi.z) / pdf), pdf, kGlossy, !reflects, false};
    return true;
}

Rgb RoughGlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kGlossy)) return Rgb(0.0f);
    const float eta = wo.dot(facets_.ng()) > 0 ? eta_ : 1 / eta_;
    const float fresnel = fresnel_dielectric(std::abs(wo.dot(facets_.ns())), eta);
    return kr_ * fresnel + kt_ * (1 - fresnel);
}

}  // namespace lxs::shading
