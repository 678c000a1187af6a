// Smooth dielectric interface. Radiance is scaled by the squared index ratio at a refraction,
// power is not (Veach 1997, section 5.2).
#include "glass_bsdf.h"

#include "fresnel.h"
#include "refraction.h"

namespace lxs::shading {

bool GlassBsdf::sample(const Vec3& wo, const Vec2&, float u_lobe, Transport transport,
                       LobeMask mask, BsdfSample& sample) const {
    if (!(mask & kSpecular)) return false;
    const bool from_front = wo.dot(ng_) > 0;
    const Vec3 n = from_front ? ns_ : -ns_;
    const float cos_o = wo.dot(n);
    if (!(cos_o > 0)) return false;
    const float eta = from_front ? eta_ : 1 / eta_;
    const float fresnel = fresnel_dielectric(cos_o, eta);
    const Rgb reflected = kr_ * film_.filter(cos_o) * fresnel, transmitted = kt_ * (1 - fresnel);
    const float total = max_component(reflected) + max_component(transmitted);
    if (!(total > 0)) return false;
    const float p_reflect = max_component(reflected) / total;
    if (u_lobe < p_reflect) {
        const Vec3 wi = reflect(wo, n);
        sample = {wi, reflected / p_reflect, 0, kSpecular, false, false};
        return same_side(wo, wi, ng_);
    }
    const Vec3 wi = refract(wo, n, eta);
    const float scale = transport == Transport::Radiance ? 1 / (eta * eta) : 1.0f;
    sample = {wi, transmitted * (scale / (1 - p_reflect)), 0, kSpecular, true, false};
    return wo.dot(ng_) * wi.dot(ng_) < 0;
}

Rgb GlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kSpecular)) return Rgb(0.0f);
    const float eta = wo.dot(ng_) > 0 ? eta_ : 1 / eta_;
    const float fresnel = fresnel_dielectric(std::abs(wo.dot(ns_)), eta);
    return kr_ * film_.filter(wo.dot(ns_)) * fresnel + kt_ * (1 - fresnel);
}

}  // namespace lxs::shading
