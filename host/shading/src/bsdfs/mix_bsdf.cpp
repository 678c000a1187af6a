// Weighted sum of two Bsdfs: one-sample model with the exact mixture density.
#include "mix_bsdf.h"

#include <algorithm>
#include "lxs/sdk/warp.h"

namespace lxs::shading {
namespace {}  // namespace

bool MixBsdf::takes_part(int child, LobeMask mask) const {
    return weights_[child] > 0 && children_[child] && (children_[child]->lobes() & mask);
}

float MixBsdf::p_second(LobeMask mask) const {
    if (!takes_part(1, mask)) return 0;
    return takes_part(0, mask) ? weights_[1] : 1.0f;
}

LobeMask MixBsdf::lobes() const {
    LobeMask lobes = 0;
    for (int i = 0; i < 2; ++i) {
        if (takes_part(i, kAllLobes)) lobes |= children_[i]->lobes();
    }
    return lobes;
}

Rgb MixBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const {
    Rgb sum(0.0f);
    for (int i = 0; i < 2; ++i) {
        if (takes_part(i, mask))
            sum += children_[i]->evaluate(wo, wi, transport, mask) * weights_[i];
    }
    return sum;
}

float MixBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    const float p = p_second(mask);
    float sum = 0;
    if (takes_part(0, mask)) sum += (1 - p) * children_[0]->pdf(wo, wi, mask);
    if (takes_part(1, mask)) sum += p * children_[1]->pdf(wo, wi, mask);
    return sum;
}

bool MixBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                     LobeMask mask, BsdfSample& sample) const {
    const float p = p_second(mask);
    const int chosen = u_lobe < p ? 1 : 0;
    if (!takes_part(chosen, mask)) return false;
    const float p_chosen = chosen == 1 ? p : 1 - p;
    const float rest = chosen == 1 ? u_lobe / p : (u_lobe - p) / (1 - p);
    if (!children_[chosen]->sample(wo, u, clamp_to_unit(rest), transport, mask, sample))
        return false;
    if (sample.lobe == kSpecular || p_chosen == 1) {
        sample.weight *= weights_[chosen] / p_chosen;
        return true;
    }
    sample.pdf = pdf(wo, sample.wi, mask);
    if (!(sample.pdf > 0)) return false;
    const Rgb f = evaluate(wo, sample.wi, transport, mask);
    sample.weight = f * (std::abs(sample.wi.dot(ns_)) / sample.pdf);
    return true;
}

Rgb MixBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    for (int i = 0; i < 2; ++i) {
        if (takes_part(i, mask)) sum += children_[i]->albedo(wo, mask) * weights_[i];
    }
    return sum;
}

bool MixBsdf::lambertian(Rgb& kd) const {
    Rgb sum(0.0f);
    for (int i = 0; i < 2; ++i) {
        Rgb part(0.0f);
        if (!takes_part(i, kAllLobes)) continue;
        if (!children_[i]->lambertian(part)) return false;
        sum += part * weights_[i];
    }
    kd = sum;
    return true;
}

}  // namespace lxs::shading
