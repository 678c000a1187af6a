// Diffuse base under a rough coating: LuxRender's "glossy".
// Sources: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"; Kulla & Conty
// 2017, "Revisiting Physically Based Shading at Imageworks" (what multiple bounces add).
#pragma once

#include "fresnel.h"
#include "lxs/sdk/bsdf.h"
#include "microfacet_albedo.h"
#include "microfacet_lobe.h"
#include "oren_nayar_shape.h"

namespace lxs::shading {

/// What the coating is made of.
struct Coating {
    Rgb reflectance{0.0f};    ///< at normal incidence (Ks, or from the index)
    Rgb optical_depth{0.0f};  ///< Ka * d: absorption along one perpendicular crossing
    bool multibounce =
        false;  ///< light that facets shadow comes out diffusely instead of being lost
    /// The base has what the coating leaves, so that white loses nothing; with multibounce.
    bool conserving = false;
    bool dielectric = false;  ///< with conserving: by the exact Fresnel term, not Schlick's

    /// What absorption leaves on one way through under `cosine` >= 0.
    Rgb transmittance(float cosine) const;
};

/// What the other side of a surface looks like that is coated on its front.
enum class CoatedBack : std::uint8_t {
    Coated,  ///< as the front
    Bare,    ///< the base alone
    Dimmed   ///< the base as under the coating, whose own reflection is missing
};

/// f = S(u) D G / (4 cos_o cos_i) + (1 - S(u)) Kd O / pi, u being the half angle's cosine and O the
/// base's shape by Oren & Nayar, 1 if it is smooth. The diffuse part is limited to what the coating
/// leaves over on the way in and on the way out, which changes grazing angles and bright bases only
/// but keeps the albedo at most 1. A conserving coating's base is, with its albedo E and that one's
/// mean, Kd (1 - E(o)) (1 - E(i)) / (pi (1 - mean)) (Kulla & Conty 2017, slide 26).
class GlossyBsdf final : public Bsdf {
  public:
    GlossyBsdf(const Rgb& kd, const Coating& coating, const MicrofacetLobe& facets, CoatedBack back,
               const OrenNayarShape& shape = OrenNayarShape(0))
        : kd_(kd),
          coating_(coating),
          facets_(facets),
          shape_(shape),
          back_(back),
          black_base_(is_black(kd)) {}

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

    /// `w` lies on a back that isn't coated.
    bool behind(const Vec3& w) const {
        return back_ != CoatedBack::Coated && w.dot(facets_.ng()) < 0;
    }
    /// Value on that side.
    Rgb back_value(const Vec3& wo, const Vec3& wi, LobeMask mask) const;
    bool sample_back(const Vec3& wo, const Vec2& u, LobeMask mask, BsdfSample& sample) const;
    Side side(const Vec3& w) const;
    Rgb base(const Side& o, const Side& i, const Rgb& fresnel, float shape) const;
    Rgb base_albedo(const Side& o) const;
    /// Multiple bounces between facets.
    Rgb coat_diffuse(const Side& o, const Side& i) const;
    Rgb bounce_color() const;
    Rgb fresnel(float cosine) const;
    /// Of a conserving coating: its greatest reflectance at normal incidence, as a dielectric's.
    float dielectric_reflectance() const;
    Rgb mean_coat() const;
    Choice choose(const Side& o, LobeMask mask) const;
    float density(const Choice& choice, const HalfVector* half, float cos_i) const;
    Rgb value(const Vec3& wo, const Vec3& wi, const Side& o, const Side& i, const HalfVector* half,
              LobeMask mask) const;

    Rgb kd_;
    Coating coating_;
    MicrofacetLobe facets_;
    OrenNayarShape shape_;
    CoatedBack back_;
    bool black_base_;
};

}  // namespace lxs::shading
