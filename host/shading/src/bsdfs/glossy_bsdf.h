// Diffuse base under a rough coating: LuxRender's "glossy".
// Sources: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"; Kulla & Conty
// 2017, "Revisiting Physically Based Shading at Imageworks" (what multiple bounces add).
#pragma once

#include "fresnel.h"
#include "lxs/sdk/bsdf.h"
#include "microfacet_albedo.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// What the coating is made of.
struct Coating {
    Rgb reflectance{0.0f};    ///< at normal incidence (Ks, or from the index)
    Rgb optical_depth{0.0f};  ///< Ka * d: absorption along one perpendicular crossing
    bool multibounce =
        false;  ///< light that facets shadow comes out diffusely instead of being lost

    /// What absorption leaves on one way through under `cosine` >= 0.
    Rgb transmittance(float cosine) const;
};

/// f = S(u) D G / (4 cos_o cos_i) + (1 - S(u)) Kd / pi, u being the half angle's cosine. The
/// diffuse part is limited to what the coating leaves over on the way in and on the way out, which
/// changes grazing angles and bright bases only but keeps the albedo at most 1.
class GlossyBsdf final : public Bsdf {
  public:
    GlossyBsdf(const Rgb& kd, const Coating& coating, const MicrofacetLobe& facets)
        : kd_(kd), coating_(coating), facets_(facets), black_base_(is_black(kd)) {}

    LobeMask lobes() const override { return black_base_ ? kGlossy : kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;
    const Rgb& kd() const { return kd_; }
    const Coating& coating() const { return coating_; }
    /// Albedo of the coating alone, seen from `w`.
    Rgb coat_albedo(const Vec3& w) const { return side(w).coat; }

  private:
    /// What is needed of one direction, besides its half vector with the other.
    struct Side {
        float cosine;
        MicrofacetAlbedo::Entry facets;
        Rgb coat;  ///< albedo of the coating
    };
    /// Probabilities of the ways to sample: the facets, the diffuse look of the coating, the base.
    struct Choice {
        float facets = 0, coat_diffuse = 0, base = 0;
    };

    Side side(const Vec3& w) const;
    Rgb base(const Side& o, const Side& i, const Rgb& fresnel) const;
    Rgb base_albedo(const Side& o) const;
    /// Multiple bounces between facets.
    Rgb coat_diffuse(const Side& o, const Side& i) const;
    Rgb bounce_color() const;
    Choice choose(const Side& o, LobeMask mask) const;
    float density(const Choice& choice, const HalfVector* half, float cos_i) const;
    Rgb value(const Side& o, const Side& i, float cosine, const HalfVector* half,
              LobeMask mask) const;

    Rgb kd_;
    Coating coating_;
    MicrofacetLobe facets_;
    bool black_base_;
};

}  // namespace lxs::shading
