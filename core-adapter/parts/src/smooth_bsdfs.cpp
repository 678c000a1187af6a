// Matte, mirror and glass.
#include "aips/parts/smooth_bsdfs.h"

#include "aips/core/sampling/sampling.h"

namespace aips {
namespace {

/// Cosine of the refracted direction; 0 where all is reflected, which makes fresnel() 1.
float cos_behind(float eta, float cos_i) {
    return std::sqrt(std::max(0.0f, 1 - eta * eta * (1 - cos_i * cos_i)));
}

/// Reflectance of unpolarised light.
float fresnel(float eta, float cos_i, float cos_t) {
    const float parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const float perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

}  // namespace

Rgb LambertBsdf::evaluate(Vec3 wo, Vec3 wi, Transport, LobeMask mask) const {
    return (mask & kDiffuse) && same_side(wo, wi) ? kd_ * kInvPi : Rgb{};
}

float LambertBsdf::pdf(Vec3 wo, Vec3 wi, LobeMask mask) const {
    if (!(mask & kDiffuse) || !same_side(wo, wi)) return 0;
    return std::max(0.0f, dot(wi, normal_towards(wo))) * kInvPi;
}

bool LambertBsdf::sample(Vec3 wo, Vec2 u, float, Transport, LobeMask mask, BsdfSample& s) const {
    if (!(mask & kDiffuse)) return false;
    const Vec3 wi = Frame(normal_towards(wo)).to_world(square_to_cosine_hemisphere(u));
    if (!same_side(wo, wi)) return false;
    s = {wi, kd_, pdf(wo, wi, mask), kDiffuse, false};
    return s.pdf > 0;
}

bool MirrorBsdf::sample(Vec3 wo, Vec2, float, Transport, LobeMask mask, BsdfSample& s) const {
    if (!(mask & kSpecular)) return false;
    s = {reflect(wo), kr_, 0, kSpecular, false};
    return same_side(wo, s.wi);
}

bool GlassBsdf::sample(Vec3 wo, Vec2, float u_lobe, Transport transport, LobeMask mask,
                       BsdfSample& s) const {
    if (!(mask & kSpecular)) return false;
    const Vec3 n = normal_towards(wo);
    const float eta = eta_from(wo);
    const float cos_i = dot(wo, n);
    if (cos_i <= 0) return false;
    const float cos_t = cos_behind(eta, cos_i);
    if (u_lobe < fresnel(eta, cos_i, cos_t)) {
        s = {reflect(wo), kWhite, 0, kSpecular, false};
        return same_side(wo, s.wi);
    }
    // Radiance that comes through the surface is squeezed into another solid angle.
    const float scale = transport == Transport::Radiance ? eta * eta : 1.0f;
    s = {n * (eta * cos_i - cos_t) - wo * eta, kWhite * scale, 0, kSpecular, false};
    return !same_side(wo, s.wi);
}

float GlassBsdf::first_specular(Vec3 wo) const {
    const float eta = eta_from(wo), cos_i = dot(wo, normal_towards(wo));
    return fresnel(eta, cos_i, cos_behind(eta, cos_i));
}

}  // namespace aips
