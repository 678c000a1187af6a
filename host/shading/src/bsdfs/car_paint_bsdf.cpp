// Diffuse base and three specular lobes: sampling and values.
#include "car_paint_bsdf.h"

#include <algorithm>

#include "channels.h"
#include "fresnel.h"

namespace lxs::shading {

Rgb CarPaintBsdf::Lobe::reflected(float cosine) const {
    return ks * fresnel_schlick(cosine, Rgb(reflectance)).x;
}

CarPaintBsdf::CarPaintBsdf(const CarPaint& paint, const Frame& frame, const Vec3& ng)
    : kd_(paint.kd),
      optical_depth_(paint.optical_depth),
      lobes_{lobe(paint.lobes[0], frame, ng), lobe(paint.lobes[1], frame, ng),
             lobe(paint.lobes[2], frame, ng)},
      frame_(frame),
      ng_(ng),
      black_base_(is_black(paint.kd)) {}

CarPaintBsdf::Lobe CarPaintBsdf::lobe(const PaintLobe& lobe, const Frame& frame, const Vec3& ng) {
    const float m = lobe.roughness;
    return {m > 0 ? lobe.ks : Rgb(0.0f), lobe.reflectance,
            MicrofacetLobe(SchlickDistribution(m, m), frame, ng)};
}

LobeMask CarPaintBsdf::seen(const Vec3& wo, LobeMask mask) const {
    return static_cast<LobeMask>(mask & (wo.dot(ng_) > 0 ? lobes() : lobes() & kDiffuse));
}

CarPaintBsdf::Choice CarPaintBsdf::choose(const Vec3& wo, LobeMask mask) const {
    const float cosine = std::abs(wo.dot(frame_.n));
    Choice choice{};
    float sum = 0;
    if (mask & kGlossy) {
        for (std::size_t i = 0; i < 3; ++i)
            choice[i] = max_component(lobes_[i].reflected(cosine));
    }
    if (mask & kDiffuse) choice[3] = max_component(kd_);
    for (const float p : choice)
        sum += p;
    for (float& p : choice)
        p = sum > 0 ? p / sum : 0.0f;
    return choice;
}

float CarPaintBsdf::density(const Choice& choice, const HalfVector& half) const {
    float sum = choice[3] * half.wi.z * kInvPi;
    for (std::size_t i = 0; i < 3; ++i) {
        if (choice[i] > 0) sum += choice[i] * lobes_[i].facets.pdf(half);
    }
    return sum;
}

Rgb CarPaintBsdf::value(const HalfVector& half, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kGlossy) {
        for (const Lobe& lobe : lobes_)
            sum += lobe.reflected(half.cosine) * lobe.facets.value(half);
    }
    if (!(mask & kDiffuse)) return sum;
    return sum + kd_ * kInvPi * absorbed(optical_depth_, 1 / half.wo.z + 1 / half.wi.z);
}

Rgb CarPaintBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    const LobeMask some = seen(wo, mask);
    HalfVector half;
    if (!some || !reflecting_half_vector(frame_, ng_, wo, wi, half)) return Rgb(0.0f);
    return value(half, some);
}

float CarPaintBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const LobeMask some = seen(wo, mask);
    HalfVector half;
    if (!some || !reflecting_half_vector(frame_, ng_, wo, wi, half)) return 0;
    return density(choose(wo, some), half);
}

bool CarPaintBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                          BsdfSample& sample) const {
    const LobeMask some = seen(wo, mask);
    if (!some) return false;
    Vec3 local;
    const float side = local_above(frame_, ng_, wo, local);
    if (side == 0) return false;
    const Choice choice = choose(wo, some);
    std::size_t chosen = 0;
    while (chosen < 3 && u_lobe >= choice[chosen])
        u_lobe -= choice[chosen++];
    if (!(choice[chosen] > 0)) return false;
    Vec3 wi;
    if (chosen == 3) {
        wi = square_to_cosine_hemisphere(u);
    } else {
        float rest = clamp_to_unit(u_lobe / choice[chosen]);
        wi = reflect(local, lobes_[chosen].facets.sample_facet(local, u, rest));
    }
    if (!(wi.z > 0)) return false;
    wi.z *= side;
    wi = frame_.to_world(wi).normalized();
    HalfVector half;
    if (!reflecting_half_vector(frame_, ng_, wo, wi, half)) return false;
    const float pdf = density(choice, half);
    if (!(pdf > 0)) return false;
    sample = {wi,    value(half, some) * (half.wi.z / pdf),
              pdf,   chosen == 3 ? kDiffuse : kGlossy,
              false, false};
    return true;
}

Rgb CarPaintBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    const LobeMask some = seen(wo, mask);
    Rgb sum(0.0f);
    if (some & kDiffuse) sum += kd_;
    if (some & kGlossy) {
        for (const Lobe& lobe : lobes_)
            sum += lobe.reflected(std::abs(wo.dot(frame_.n)));
    }
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
