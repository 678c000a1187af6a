// Diffuse base and three specular lobes: LuxRender's "carpaint".
// Sources: Guenther, Chen, Goesele, Wald & Seidel 2005, "Efficient Acquisition and Realistic
// Rendering of Car Paint" (several lobes added up); Cook & Torrance 1982, "A Reflectance Model for
// Computer Graphics" (each lobe).
#pragma once

#include <array>

#include "lxs/sdk/bsdf.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// One Cook-Torrance lobe: f = Ks F D G / (4 cos_o cos_i) with Beckmann's D, normalised, the
/// V-cavities' G and Schlick's F.
struct CookTorranceLobe {
    Rgb ks{0.0f};           ///< weight
    float reflectance = 0;  ///< of a facet at normal incidence (R)
    float slope = 0.1f;     ///< root mean square slope of the facets (M), > 0

    Rgb value(const HalfVector& half) const;
    /// Density of `sample`.
    float pdf(const HalfVector& half) const;
    /// Facet that is visible from the local direction `wo`.
    Vec3 sample(const Vec3& wo, const Vec2& u, float& u_choice) const;
    /// Approximate albedo under the cosine `c`.
    Rgb albedo(float c) const;

  private:
    float density(const Vec3& h) const;
};

struct CarPaint {
    Rgb kd{0.0f};
    Rgb optical_depth{0.0f};  ///< Ka * d of the coating above the diffuse base
    std::array<CookTorranceLobe, 3> lobes;
};

class CarPaintBsdf final : public Bsdf {
  public:
    CarPaintBsdf(const CarPaint& paint, const Frame& frame, const Vec3& ng)
        : paint_(paint), frame_(frame), ng_(ng), black_base_(is_black(paint.kd)) {}

    LobeMask lobes() const override { return black_base_ ? kGlossy : kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// Probabilities of the three lobes and, last, of the base.
    using Choice = std::array<float, 4>;
    Choice choose(const Vec3& wo, LobeMask mask) const;
    float density(const Choice& choice, const HalfVector& half) const;
    Rgb value(const HalfVector& half, LobeMask mask) const;

    CarPaint paint_;
    Frame frame_;
    Vec3 ng_;
    bool black_base_;
};

}  // namespace lxs::shading
