// Diffuse base and three specular lobes: sampling and values.
#include "car_paint_bsdf.h"

#include <algorithm>

#include "channels.h"
#include "fresnel.h"

namespace lxs::shading {

float CookTorranceLobe::density(const Vec3& h) const {
    const float cos2 = h.z * h.z, m2 = slope * slope;
    const float tan2 = (h.x * h.x + h.y * h.y) / cos2;
    return std::exp(-tan2 / m2) * kInvPi / (m2 * cos2 * cos2);
}

Rgb CookTorranceLobe::value(const HalfVector& half) const {
    const float d = density(half.h);
    if (!(d > 0)) return Rgb(0.0f);
    const float cos_o = half.wo.z, cos_i = half.wi.z, wall = 2 * half.h.z / half.cosine;
    // G / (cos_o cos_i)
    const float seen = std::min(1.0f, wall * std::min(cos_o, cos_i)) / (cos_o * cos_i);
    return ks * (0.25f * d * seen * fresnel_schlick(half.cosine, Rgb(reflectance)).x);
}

float CookTorranceLobe::pdf(const HalfVector& half) const {
    return 0.25f * density(half.h) * std::min(1 / half.wo.z, 2 * half.h.z / half.cosine);
}

Vec3 CookTorranceLobe::sample(const Vec3& wo, const Vec2& u, float& u_choice) const {
    const float tan2 = -slope * slope * std::log(1 - u.x);
    const float cosine = 1 / std::sqrt(1 + tan2), sine = std::sqrt(tan2) * cosine;
    const float phi = 2 * kPi * u.y;
    return visible_wall(wo, {sine * std::cos(phi), sine * std::sin(phi), cosine}, u_choice);
}

Rgb CookTorranceLobe::albedo(float c) const {
    return ks * fresnel_schlick(c, Rgb(reflectance)).x;
}

CarPaintBsdf::Choice CarPaintBsdf::choose(const Vec3& wo, LobeMask mask) const {
    const float cosine = std::abs(wo.dot(frame_.n));
    Choice choice{};
    float sum = 0;
    if (mask & kGlossy) {
        for (int i = 0; i < 3; ++i)
            choice[i] = max_component(paint_.lobes[i].albedo(cosine));
    }
    if (mask & kDiffuse) choice[3] = max_component(paint_.kd);
    for (const float p : choice)
        sum += p;
    for (float& p : choice)
        p = sum > 0 ? p / sum : 0.0f;
    return choice;
}

float CarPaintBsdf::density(const Choice& choice, const HalfVector& half) const {
    float sum = choice[3] * half.wi.z * kInvPi;
    for (int i = 0; i < 3; ++i) {
        if (choice[i] > 0) sum += choice[i] * paint_.lobes[i].pdf(half);
    }
    return sum;
}

Rgb CarPaintBsdf::value(const HalfVector& half, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kGlossy) {
        for (const CookTorranceLobe& lobe : paint_.lobes)
            sum += lobe.value(half);
    }
    if (!(mask & kDiffuse) || black_base_) return sum;
    return sum + paint_.kd * kInvPi * absorbed(paint_.optical_depth, 1 / half.wo.z + 1 / half.wi.z);
}

Rgb CarPaintBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    HalfVector half;
    if (!(mask & lobes()) || !reflecting_half_vector(frame_, ng_, wo, wi, half)) return Rgb(0.0f);
    return value(half, mask);
}

float CarPaintBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    HalfVector half;
    if (!(mask & lobes()) || !reflecting_half_vector(frame_, ng_, wo, wi, half)) return 0;
    return density(choose(wo, mask), half);
}

bool CarPaintBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                          BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    Vec3 local;
    const float side = local_above(frame_, ng_, wo, local);
    if (side == 0) return false;
    const Choice choice = choose(wo, mask);
    int chosen = 0;
    while (chosen < 3 && u_lobe >= choice[chosen])
        u_lobe -= choice[chosen++];
    if (!(choice[chosen] > 0)) return false;
    Vec3 wi;
    if (chosen == 3) {
        wi = square_to_cosine_hemisphere(u);
    } else {
        float rest = clamp_to_unit(u_lobe / choice[chosen]);
        wi = reflect(local, paint_.lobes[chosen].sample(local, u, rest));
    }
    if (!(wi.z > 0)) return false;
    wi.z *= side;
    wi = frame_.to_world(wi).normalized();
    HalfVector half;
    if (!reflecting_half_vector(frame_, ng_, wo, wi, half)) return false;
    const float pdf = density(choice, half);
    if (!(pdf > 0)) return false;
    sample = {wi,    value(half, mask) * (half.wi.z / pdf),
              pdf,   chosen == 3 ? kDiffuse : kGlossy,
              false, false};
    return true;
}

Rgb CarPaintBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kDiffuse) sum += paint_.kd;
    if (mask & kGlossy) {
        for (const CookTorranceLobe& lobe : paint_.lobes)
            sum += lobe.albedo(std::abs(wo.dot(frame_.n)));
    }
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
