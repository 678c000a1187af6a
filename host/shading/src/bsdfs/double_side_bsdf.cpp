// One Bsdf for each side of a surface: sampling and values.
#include "double_side_bsdf.h"

#include <algorithm>
#include <cmath>
#include "lxs/sdk/warp.h"

namespace lxs::shading {

const Bsdf* DoubleSideBsdf::side_of(const Vec3& w, LobeMask mask) const {
    const Bsdf* bsdf = sides_[w.dot(ng_) < 0 ? 1 : 0];
    return bsdf && (bsdf->lobes() & mask) ? bsdf : nullptr;
}

float DoubleSideBsdf::p_own(const Vec3& wo, LobeMask mask) const {
    if (!side_of(wo, mask)) return 0;
    return transmits_ && other_side(wo, mask) ? 0.5f : 1.0f;
}

LobeMask DoubleSideBsdf::lobes() const {
    LobeMask lobes = 0;
    for (const Bsdf* side : sides_) {
        if (side) lobes |= side->lobes();
    }
    return lobes;
}

Rgb DoubleSideBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                             LobeMask mask) const {
    const Bsdf* side = side_of(transport == Transport::Radiance ? wo : wi, mask);
    return side ? side->evaluate(wo, wi, transport, mask) : Rgb(0.0f);
}

float DoubleSideBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const float p = p_own(wo, mask);
    float sum = 0;
    if (p > 0) sum += p * side_of(wo, mask)->pdf(wo, wi, mask);
    if (p < 1 && transmits_ && wo.dot(ng_) * wi.dot(ng_) < 0) {
        if (const Bsdf* other = other_side(wo, mask)) sum += (1 - p) * other->pdf(wo, wi, mask);
    }
    return sum;
}

bool DoubleSideBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                            LobeMask mask, BsdfSample& sample) const {
    const float p = p_own(wo, mask);
    const bool own = u_lobe < p;
    const Bsdf* chosen = own ? side_of(wo, mask) : other_side(wo, mask);
    if (!chosen || (!own && !transmits_)) return false;
    const float rest = own ? u_lobe / p : (u_lobe - p) / (1 - p);
    if (!chosen->sample(wo, u, clamp_to_unit(rest), transport, mask, sample)) return false;
    if (!own && !sample.transmitted) return false;
    if (sample.lobe == kSpecular) {
        const bool decides = own == (transport == Transport::Radiance || !sample.transmitted);
        sample.weight *= 1 / (own ? p : 1 - p);
        return decides;
    }
    sample.pdf = pdf(wo, sample.wi, mask);
    if (!(sample.pdf > 0)) return false;
    sample.weight =
        evaluate(wo, sample.wi, transport, mask) * (std::abs(sample.wi.dot(ns_)) / sample.pdf);
    return true;
}

Rgb DoubleSideBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    const Bsdf* side = side_of(wo, mask);
    return side ? side->albedo(wo, mask) : Rgb(0.0f);
}

}  // namespace lxs::shading
