// Diffuse base and three specular lobes: LuxRender's "carpaint".
// Sources: Guenther, Chen, Goesele, Wald & Seidel 2005, "Efficient Acquisition and Realistic
// Rendering of Car Paint" (several lobes added up); Schlick 1994, "An Inexpensive BRDF Model for
// Physically-based Rendering" (each lobe's facets: LuxRender has his in place of Cook &
// Torrance's).
#pragma once

#include <array>

#include "lxs/sdk/bsdf.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// One lobe: f = Ks F D G / (4 cos_o cos_i) with Schlick's D, G and F. Without a Ks or a roughness
/// it is none.
struct PaintLobe {
    Rgb ks{0.0f};           ///< weight
    float reflectance = 0;  ///< of a facet at normal incidence (R)
    float roughness = 0;    ///< M, as the roughness along both axes of a metal
};

struct CarPaint {
    Rgb kd{0.0f};
    Rgb optical_depth{0.0f};  ///< Ka * d of the coating above the diffuse base
    std::array<PaintLobe, 3> lobes;
};

/// The lobes lie on the front alone, the base on both sides.
class CarPaintBsdf final : public Bsdf {
  public:
    CarPaintBsdf(const CarPaint& paint, const Frame& frame, const Vec3& ng);

    LobeMask lobes() const override { return black_base_ ? kGlossy : kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// A lobe's colour, by its facets' Fresnel term, and its facets.
    struct Lobe {
        Rgb ks;
        float reflectance;
        MicrofacetLobe facets;

        Rgb reflected(float cosine) const;
    };
    static Lobe lobe(const PaintLobe& lobe, const Frame& frame, const Vec3& ng);
    /// Probabilities of the three lobes and, last, of the base.
    using Choice = std::array<float, 4>;
    Choice choose(const Vec3& wo, LobeMask mask) const;
    /// Those of `mask` that are seen from `wo`.
    LobeMask seen(const Vec3& wo, LobeMask mask) const;
    float density(const Choice& choice, const HalfVector& half) const;
    Rgb value(const HalfVector& half, LobeMask mask) const;

    Rgb kd_, optical_depth_;
    std::array<Lobe, 3> lobes_;
    Frame frame_;
    Vec3 ng_;
    bool black_base_;
};

}  // namespace lxs::shading
