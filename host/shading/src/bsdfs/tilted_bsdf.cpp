// A Bsdf about a tilted normal: sides, and cosines to another normal.
#include "tilted_bsdf.h"

#include <algorithm>
#include <cmath>

#include "directions.h"

namespace lxs::shading {

bool TiltedBsdf::joins(const Vec3& wo, const Vec3& wi) const {
    return !same_side(wo, wi, ng_) || same_side(wo, wi, tilted_);
}

float TiltedBsdf::cosine_ratio(const Vec3& w) const {
    if (tilted_ == ns_) return 1;
    return std::abs(w.dot(tilted_)) / std::max(std::abs(w.dot(ns_)), kMinCosine);
}

Rgb TiltedBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const {
    if (!joins(wo, wi)) return Rgb(0.0f);
    const Rgb f = part_.evaluate(wo, wi, transport, mask);
    return is_black(f) ? f : f * cosine_ratio(transport == Transport::Radiance ? wi : wo);
}

float TiltedBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    return joins(wo, wi) ? part_.pdf(wo, wi, mask) : 0;
}

bool TiltedBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                        LobeMask mask, BsdfSample& sample) const {
    if (!part_.sample(wo, u, u_lobe, transport, mask, sample)) return false;
    if (!sample.transmitted && !joins(wo, sample.wi)) return false;
    if (transport == Transport::Radiance || sample.straight) return true;
    const float back = cosine_ratio(sample.wi);
    if (!(back > 0)) return false;
    sample.weight *= cosine_ratio(wo) / back;
    return true;
}

}  // namespace lxs::shading
