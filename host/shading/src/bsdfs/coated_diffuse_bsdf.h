// Diffuse base under a rough dielectric coat, with all light that goes to and fro between them.
#pragma once

#include "coat_table.h"
#include "lxs/sdk/bsdf.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// f = F D G / (4 cos_o cos_i) + k / pi t(o) t(i) / n^2 (1 + k r + (k r)^2 + ...), t being what the
/// coat of index n lets through to the base of reflectance k, and r what it throws back to it: of
/// the light that comes to the base as often as `bounces` says.
class CoatedDiffuseBsdf final : public Bsdf {
  public:
    /// `coat` is of that index and outlives the Bsdf; the facets are by Trowbridge and Reitz.
    CoatedDiffuseBsdf(const Rgb& kd, float index, int bounces, const CoatTable& coat,
                      const MicrofacetLobe& facets);

    LobeMask lobes() const override { return is_black(base_) ? kGlossy : kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    CoatTable::Entry coat_at(const Vec3& w) const {
        return coat_.at(alpha_, std::abs(w.dot(facets_.ns())));
    }
    /// Probability of drawing a facet, not a direction of the base.
    float p_facet(const CoatTable::Entry& seen, LobeMask mask) const;
    /// Value and density of a pair of directions.
    struct Weighed {
        Rgb f{0.0f};
        float pdf = 0;
    };
    Weighed weigh(const Vec3& wo, const Vec3& wi, const CoatTable::Entry& seen,
                  LobeMask mask) const;

    Rgb base_;  ///< of f: what stands before t(o) t(i)
    float index_, alpha_, mean_transmitted_;
    const CoatTable& coat_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
