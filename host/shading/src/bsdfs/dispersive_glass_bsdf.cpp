// Smooth dielectric interface that bends each wavelength its own way.
#include "dispersive_glass_bsdf.h"

#include <algorithm>
#include <cmath>

#include "fresnel.h"
#include "refraction.h"

namespace lxs::shading {
namespace {

Rgb fresnel_by_component(const Rgb& eta, float cos_o, bool from_front) {
    const auto share = [&](float index) {
        return fresnel_dielectric(cos_o, from_front ? index : 1 / index);
    };
    return {share(eta.x), share(eta.y), share(eta.z)};
}

float sum(const Rgb& c) {
    return c.x + c.y + c.z;
}

}  // namespace

Rgb DispersiveGlassBsdf::carried() const {
    if (component_ == kAllComponents) return Rgb(1.0f);
    Rgb one(0.0f);
    one[component_] = 1;
    return one;
}

Rgb DispersiveGlassBsdf::reflected(const Vec3& wo) const {
    return carried() * kr_ * film_.filter(wo.dot(ns_)) *
           fresnel_by_component(eta_, std::abs(wo.dot(ns_)), wo.dot(ng_) > 0);
}

Rgb DispersiveGlassBsdf::transmitted(const Vec3& wo) const {
    const Rgb share = fresnel_by_component(eta_, std::abs(wo.dot(ns_)), wo.dot(ng_) > 0);
    return carried() * kt_ * (Rgb(1.0f) - share);
}

float DispersiveGlassBsdf::first_specular(const Vec3& wo) const {
    return share_of_first(sum(reflected(wo)), sum(transmitted(wo)));
}

bool DispersiveGlassBsdf::sample(const Vec3& wo, const Vec2&, float u_lobe, Transport transport,
                                 LobeMask mask, BsdfSample& sample) const {
    if (!(mask & kSpecular)) return false;
    const bool from_front = wo.dot(ng_) > 0;
    const Vec3 n = from_front ? ns_ : -ns_;
    if (!(wo.dot(n) > 0)) return false;
    const Rgb back = reflected(wo), through = transmitted(wo);
    if (!(sum(back) + sum(through) > 0)) return false;
    const float p_reflect = share_of_first(sum(back), sum(through));
    if (u_lobe < p_reflect) {
        const Vec3 wi = reflect(wo, n);
        sample = {wi, back / p_reflect, 0, kSpecular, false, false};
        return same_side(wo, wi, ng_);
    }
    const Rgb choices = carried();
    const float u_component = std::min((u_lobe - p_reflect) / (1 - p_reflect), 0x1.fffffep-1f);
    const int component =
        component_ != kAllComponents ? component_ : static_cast<int>(3 * u_component);
    const float eta = from_front ? eta_[component] : 1 / eta_[component];
    const float scale = transport == Transport::Radiance ? 1 / (eta * eta) : 1.0f;
    Rgb weight(0.0f);
    weight[component] = through[component] * scale * sum(choices) / (1 - p_reflect);
    if (!(weight[component] > 0)) return false;  // reflected totally
    const Vec3 wi = refract(wo, n, eta);
    sample = {wi, weight, 0, kSpecular, true, false, static_cast<std::int8_t>(component)};
    return wo.dot(ng_) * wi.dot(ng_) < 0;
}

Rgb DispersiveGlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    return mask & kSpecular ? reflected(wo) + transmitted(wo) : Rgb(0.0f);
}

}  // namespace lxs::shading
