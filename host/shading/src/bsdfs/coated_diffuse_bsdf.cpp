// Diffuse base under a rough dielectric coat.
#include "coated_diffuse_bsdf.h"

#include <algorithm>
#include <cmath>

#include "directions.h"
#include "fresnel.h"

namespace lxs::shading {

CoatedDiffuseBsdf::CoatedDiffuseBsdf(const Rgb& kd, float index, int bounces, const CoatTable& coat,
                                     const MicrofacetLobe& facets)
    : index_(index), alpha_(std::sqrt(facets.roughness())), coat_(coat), facets_(facets) {
    const CoatTable::Means means = coat.means(alpha_);
    mean_transmitted_ = means.transmitted;
    for (int c = 0; c < 3; ++c) {
        const float again = kd[c] * means.thrown_back;
        const float all = (1 - std::pow(again, static_cast<float>(bounces))) / (1 - again);
        base_[c] = kd[c] * all * kInvPi / (index * index);
    }
}

float CoatedDiffuseBsdf::p_facet(const CoatTable::Entry& seen, LobeMask mask) const {
    if (!(mask & kDiffuse) || is_black(base_)) return 1;
    if (!(mask & kGlossy)) return 0;
    const float base = max_component(base_) * kPi * seen.transmitted * mean_transmitted_;
    // Both parts keep a share: their estimates are means over channels and directions.
    return std::clamp(seen.reflected / std::max(seen.reflected + base, 1e-6f), 0.1f, 0.9f);
}

CoatedDiffuseBsdf::Weighed CoatedDiffuseBsdf::weigh(const Vec3& wo, const Vec3& wi,
                                                    const CoatTable::Entry& seen,
                                                    LobeMask mask) const {
    const float p = p_facet(seen, mask);
    Weighed weighed;
    if (mask & kDiffuse) weighed.f = base_ * (seen.transmitted * coat_at(wi).transmitted);
    weighed.pdf = (1 - p) * std::abs(wi.dot(facets_.ns())) * kInvPi;
    HalfVector half;
    if (p > 0 && facets_.half_vector(wo, wi, half)) {
        weighed.f += Rgb(fresnel_dielectric(half.cosine, index_) * facets_.value(half));
        weighed.pdf += p * facets_.pdf(half);
    }
    return weighed;
}

Rgb CoatedDiffuseBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return Rgb(0.0f);
    return weigh(wo, wi, coat_at(wo), mask).f;
}

float CoatedDiffuseBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    if (!(mask & lobes()) || !same_side(wo, wi, facets_.ng())) return 0;
    return weigh(wo, wi, coat_at(wo), mask).pdf;
}

bool CoatedDiffuseBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport,
                               LobeMask mask, BsdfSample& sample) const {
    if (!(mask & lobes())) return false;
    const CoatTable::Entry seen = coat_at(wo);
    const float p = p_facet(seen, mask);
    const bool facet = u_lobe < p;
    Vec3 wi;
    HalfVector half;
    if (facet ? !facets_.sample(wo, u, clamp_to_unit(u_lobe / p), wi, half)
              : !sample_cosine(wo, facets_.ng(), facets_.ns(), u, wi))
        return false;
    const Weighed weighed = weigh(wo, wi, seen, mask);
    if (!(weighed.pdf > 0) || !same_side(wo, wi, facets_.ng())) return false;
    sample = {wi,          weighed.f * (std::abs(wi.dot(facets_.ns())) / weighed.pdf),
              weighed.pdf, facet ? kGlossy : kDiffuse,
              false,       false};
    return true;
}

Rgb CoatedDiffuseBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    const CoatTable::Entry seen = coat_at(wo);
    Rgb sum(mask & kGlossy ? seen.reflected : 0.0f);
    if (mask & kDiffuse) sum += base_ * (kPi * seen.transmitted * mean_transmitted_);
    return sum;
}

}  // namespace lxs::shading
