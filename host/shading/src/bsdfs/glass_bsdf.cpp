// Smooth dielectric interface. Radiance is scaled by the squared index ratio at a refraction,
// power is not (Veach 1997, section 5.2).
#include "glass_bsdf.h"

#include "fresnel.h"
#include "refraction.h"

namespace lxs::shading {

bool GlassBsdf::meet(const Vec3& wo, Meeting& met) const {
    const bool from_front = wo.dot(ng_) > 0;
    met.n = from_front ? ns_ : -ns_;
    const float cos_o = wo.dot(met.n);
    if (!(cos_o > 0)) return false;
    met.eta = from_front ? eta_ : 1 / eta_;
    const float fresnel = fresnel_dielectric(cos_o, met.eta);
    met.reflected = kr_ * film_.filter(cos_o) * fresnel;
    met.transmitted = kt_ * (1 - fresnel);
    const float back = max_component(met.reflected), through = max_component(met.transmitted);
    met.p_reflect = share_of_first(back, through);
    return back + through > 0;
}

bool GlassBsdf::sample(const Vec3& wo, const Vec2&, float u_lobe, Transport transport,
                       LobeMask mask, BsdfSample& sample) const {
    Meeting met;
    if (!(mask & kSpecular) || !meet(wo, met)) return false;
    if (u_lobe < met.p_reflect) {
        const Vec3 wi = reflect(wo, met.n);
        sample = {wi, met.reflected / met.p_reflect, 0, kSpecular, false, false};
        return same_side(wo, wi, ng_);
    }
    const Vec3 wi = refract(wo, met.n, met.eta);
    const float scale = transport == Transport::Radiance ? 1 / (met.eta * met.eta) : 1.0f;
    sample = {wi, met.transmitted * (scale / (1 - met.p_reflect)), 0, kSpecular, true, false};
    return wo.dot(ng_) * wi.dot(ng_) < 0;
}

float GlassBsdf::first_specular(const Vec3& wo) const {
    Meeting met;
    return meet(wo, met) ? met.p_reflect : 0;
}

Rgb GlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kSpecular)) return Rgb(0.0f);
    const float eta = wo.dot(ng_) > 0 ? eta_ : 1 / eta_;
    const float fresnel = fresnel_dielectric(std::abs(wo.dot(ns_)), eta);
    return kr_ * film_.filter(wo.dot(ns_)) * fresnel + kt_ * (1 - fresnel);
}

}  // namespace lxs::shading
