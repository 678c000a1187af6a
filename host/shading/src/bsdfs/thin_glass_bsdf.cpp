// Architectural glass: one rule for eye paths, photons and shadow rays.
#include "thin_glass_bsdf.h"

#include "fresnel.h"

namespace lxs::shading {
namespace {

float thin_fresnel(float eta, float cos_o) {
    return fresnel_dielectric(std::abs(cos_o), std::max(eta, 1 / eta));
}

}  // namespace

Rgb thin_glass_transmission(const Rgb& kt, float eta, float cos_o, bool pane) {
    const float fresnel = thin_fresnel(eta, cos_o);
    return kt * (pane ? (1 - fresnel) / (1 + fresnel) : 1 - fresnel);
}

Rgb ThinGlassBsdf::reflection(const Vec3& wo) const {
    if (!pane_ && wo.dot(ng_) <= 0) return Rgb(0.0f);
    const float cosine = wo.dot(ns_), fresnel = thin_fresnel(eta_, cosine);
    return kr_ * film_.filter(cosine) * (pane_ ? 2 * fresnel / (1 + fresnel) : fresnel);
}

float ThinGlassBsdf::first_specular(const Vec3& wo) const {
    const Rgb transmitted = thin_glass_transmission(kt_, eta_, wo.dot(ns_), pane_);
    return share_of_first(max_component(reflection(wo)), max_component(transmitted));
}

bool ThinGlassBsdf::sample(const Vec3& wo, const Vec2&, float u_lobe, Transport, LobeMask mask,
                           BsdfSample& sample) const {
    if (!(mask & kSpecular)) return false;
    const Rgb reflected = reflection(wo);
    const Rgb transmitted = thin_glass_transmission(kt_, eta_, wo.dot(ns_), pane_);
    const float back = max_component(reflected), through = max_component(transmitted);
    if (!(back + through > 0)) return false;
    const float p_reflect = share_of_first(back, through);
    if (u_lobe >= p_reflect) {
        sample = {-wo, transmitted / (1 - p_reflect), 0, kSpecular, true, true};
        return true;
    }
    const Vec3 wi = reflect(wo, ns_);
    sample = {wi, reflected / p_reflect, 0, kSpecular, false, false};
    return same_side(wo, wi, ng_);
}

Rgb ThinGlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    if (!(mask & kSpecular)) return Rgb(0.0f);
    const float cos_o = wo.dot(ns_);
    return reflection(wo) + thin_glass_transmission(kt_, eta_, cos_o, pane_);
}

}  // namespace lxs::shading
