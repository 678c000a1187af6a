// Rough dielectric interface: LuxRender's "roughglass".
// Source: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
#pragma once

#include "lxs/sdk/bsdf.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// Facets, each of which reflects F and refracts 1 - F of what it gets.
class RoughGlassBsdf final : public Bsdf {
  public:
    /// `eta`: index behind the surface / index before it, not 1. `kr` and `kt` tint what is
    /// reflected and what is refracted.
    RoughGlassBsdf(const Rgb& kr, const Rgb& kt, float eta, const MicrofacetLobe& facets)
        : kr_(kr), kt_(kt), eta_(eta), facets_(facets) {}

    LobeMask lobes() const override { return kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// Two directions and the facet that carries light between them, in local coordinates with
    /// wo.z > 0; wi.z < 0 if it refracts.
    struct Crossing {
        Vec3 wo{0.0f}, wi{0.0f}, h{0.0f};
        float cos_o = 0, cos_i = 0;  ///< with h; cos_i < 0 if it refracts
        float eta = 1;               ///< index on the other side / index on wo's side
        float fresnel = 0;

        bool refracts() const { return wi.z < 0; }
        /// wo.h + eta wi.h: the length of the refracting half vector.
        float length() const { return cos_o + eta * cos_i; }
    };

    /// False if no facet carries light from one to the other.
    bool crossing(const Vec3& wo, const Vec3& wi, Crossing& crossing) const;
    float p_reflect(float fresnel) const;
    Rgb value(const Crossing& c, Transport transport) const;
    float density(const Crossing& c) const;

    Rgb kr_, kt_;
    float eta_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
