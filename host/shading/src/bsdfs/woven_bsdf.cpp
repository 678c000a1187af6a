// A point on a yarn of woven cloth: sampling and values.
#include "woven_bsdf.h"

#include <algorithm>
#include <cmath>

#include "lxs/sdk/warp.h"

namespace lxs::shading {

float WovenBsdf::seen_area(const Vec3& w) const {
    constexpr float kMinHeight = 1e-6f;  // of a normal at the very edge of a yarn
    const float facing = std::max(0.0f, yarn_.normal.dot(w));
    return std::min(w.z, facing / std::max(yarn_.normal.z, kMinHeight));
}

Rgb WovenBsdf::value(const HalfVector& pair, LobeMask mask) const {
    constexpr float kMinArea = 1e-6f;  // keeps f finite where both directions graze the yarn
    Rgb sum(0.0f);
    if ((mask & kDiffuse) && !black_base_) sum += kd_ * kInvPi;
    if (!(mask & kGlossy)) return sum;
    const float m_o = seen_area(pair.wo), m_i = seen_area(pair.wi);
    if (!(m_o > 0 && m_i > 0)) return sum;
    const float layer =
        (m_o / pair.wo.z) * (m_i / pair.wi.z) * (1 + m_o * m_i) / std::max(m_o + m_i, kMinArea);
    return sum + ks_ * (layer * yarn_.fibres.value(yarn_.tangent, pair.wo, pair.wi));
}

WovenBsdf::Choice WovenBsdf::choose(const Vec3& wo, LobeMask mask) const {
    Choice choice;
    // By what either can reflect at most: no sample weighs more than the sum of the two.
    if ((mask & kGlossy) && seen_area(wo) > 0) choice.fibres = max_component(ks_);
    if (mask & kDiffuse) choice.base = max_component(kd_);
    const float sum = choice.fibres + choice.base;
    if (!(sum > 0)) return {};
    choice.fibres /= sum;
    choice.base = 1 - choice.fibres;
    return choice;
}

float WovenBsdf::density(const Choice& choice, const HalfVector& pair) const {
    float sum = choice.base * pair.wi.z * kInvPi;
    if (choice.fibres > 0)
        sum += choice.fibres * yarn_.fibres.value(yarn_.tangent, pair.wo, pair.wi);
    return sum;
}

Rgb WovenBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    HalfVector pair;
    if (!(mask & lobes()) || !reflecting_half_vector(frame_, ng_, wo, wi, pair)) return Rgb(0.0f);
    return value(pair, mask);
}

float WovenBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    HalfVector pair;
    if (!(mask & lobes()) || !reflecting_half_vector(frame_, ng_, wo, wi, pair)) return 0;
    return density(choose(pair.wo, mask), pair);
}

bool WovenBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask mask,
                       BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    Vec3 local;
    const float side = local_above(frame_, ng_, wo, local);
    if (side == 0) return false;
    const Choice choice = choose(local, mask);
    const bool by_fibres = u_lobe < choice.fibres;
    if (!by_fibres && !(choice.base > 0)) return false;
    Vec3 wi = by_fibres ? yarn_.fibres.sample(yarn_.tangent, local, u,
                                              clamp_to_unit(u_lobe / choice.fibres))
                        : square_to_cosine_hemisphere(u);
    wi.z *= side;
    wi = frame_.to_world(wi).normalized();
    HalfVector pair;
    if (!reflecting_half_vector(frame_, ng_, wo, wi, pair)) return false;
    const float pdf = density(choice, pair);
    if (!(pdf > 0)) return false;
    sample = {wi,    value(pair, mask) * (pair.wi.z / pdf),
              pdf,   by_fibres ? kGlossy : kDiffuse,
              false, false};
    return true;
}

Rgb WovenBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    if (mask & kDiffuse) sum += kd_;
    const float cosine = std::abs(wo.dot(frame_.n));
    if (!(mask & kGlossy) || !(cosine > 0)) return sum;
    Vec3 local = frame_.to_local(wo);
    local.z = cosine;
    // What of the phase function leaves the cloth, fitted to its presets, at a mean area.
    constexpr float kUpwards = 0.42f, kMeanArea = 0.6f;
    const float m = seen_area(local);
    const float layer = kMeanArea * (1 + kMeanArea * m) / (kMeanArea + m);
    return sum + ks_ * (kUpwards * layer * m / cosine);
}

}  // namespace lxs::shading
