// Reflection by a surface of microfacets, Fresnel term left out.
// Sources: Schlick 1994; Heitz & d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
// Distribution of Visible Normals" (V-cavities, for sampling Schlick's facets only).
#pragma once

#include <variant>

#include "schlick_distribution.h"
#include "trowbridge_reitz.h"

namespace lxs::shading {

/// Two directions and their half vector in local coordinates, on the side where local z > 0.
struct HalfVector {
    Vec3 wo{0.0f}, wi{0.0f}, h{0.0f};
    float cosine = 0;  ///< wo.h = wi.h, > 0
};

/// `wo` in local coordinates with z > 0, whichever side it lies on; returns 1 or -1, by which a
/// local direction's z goes back to that side, or 0 if the shading frame doesn't see `wo`.
float local_above(const Frame& frame, const Vec3& ng, const Vec3& wo, Vec3& local);

/// Half vector of two directions at a surface with shading frame `frame` and geometric normal `ng`;
/// false when they don't see each other by reflection.
bool reflecting_half_vector(const Frame& frame, const Vec3& ng, const Vec3& wo, const Vec3& wi,
                            HalfVector& half);

/// One of the two walls of the V-cavity that `h` stands in, chosen by the area that the local
/// direction `wo` sees of it; uses up a part of `u_choice` (Heitz & d'Eon 2014, algorithm 2).
Vec3 visible_wall(const Vec3& wo, const Vec3& h, float& u_choice);

/// Facets of LuxRender, or of most other renderers.
using FacetDistribution = std::variant<SchlickDistribution, TrowbridgeReitz>;

/// f = D G / (4 cos_o cos_i). Of Schlick's facets G is his product of shadowing terms, as LuxRender
/// has it, but scaled down at grazing angles, where that would send back more light than arrives.
class MicrofacetLobe {
  public:
    MicrofacetLobe(const FacetDistribution& distribution, const Frame& frame, const Vec3& ng)
        : distribution_(distribution), frame_(frame), ng_(ng) {}

    const Vec3& ng() const { return ng_; }
    const Vec3& ns() const { return frame_.n; }
    const Frame& frame() const { return frame_; }
    float roughness() const {
        return std::visit([](const auto& facets) { return facets.roughness(); }, distribution_);
    }
    bool grained() const {
        return std::visit([](const auto& facets) { return facets.grained(); }, distribution_);
    }
    /// D(h) of the facets.
    float density(const Vec3& h) const {
        return std::visit([&](const auto& facets) { return facets.density(h); }, distribution_);
    }
    /// G / |cos_o cos_i| of two local directions, on either side.
    float shadowing(const Vec3& wo, const Vec3& wi) const;
    /// Draws a facet visible from the local direction `wo`, wo.z > 0; uses up a part of
    /// `u_choice`.
    Vec3 sample_facet(const Vec3& wo, const Vec2& u, float& u_choice) const;
    /// Density of `sample_facet` per steradian of h, over wo.h.
    float facet_pdf(const Vec3& wo, const Vec3& h, float cosine) const;

    /// False when the two directions don't see each other by reflection.
    bool half_vector(const Vec3& wo, const Vec3& wi, HalfVector& half) const;
    /// f without Fresnel term.
    float value(const HalfVector& half) const;
    /// Density of `sample`.
    float pdf(const HalfVector& half) const;
    /// Draws wi among the facets visible from wo; `u_choice` in [0,1). False if wi is shadowed.
    bool sample(const Vec3& wo, const Vec2& u, float u_choice, Vec3& wi, HalfVector& half) const;

  private:
    FacetDistribution distribution_;
    Frame frame_;
    Vec3 ng_;
};

}  // namespace lxs::shading
