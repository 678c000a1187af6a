// Single scattering in a thin layer of fibres on a black surface: LuxRender's "velvet".
// Source: Koenderink & Pont 2003, "The Secret of Velvety Skin", Machine Vision and Applications 14.
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// Phase function of the fibres: 1 + p1 P1(c) + p2 P2(c) + p3 P3(c), P being Legendre polynomials
/// and c the cosine of the deflection (1 goes straight on), where that is above 0.
struct FibrePhase {
    float p1 = -2, p2 = 20, p3 = 2;

    float operator()(float c) const {
        const float c2 = c * c;
        const float p = 1 + p1 * c + p2 * 0.5f * (3 * c2 - 1) + p3 * 0.5f * c * (5 * c2 - 3);
        return p > 0 ? p : 0.0f;
    }
};

/// f = Kd d p(c) / (4 pi cos_o cos_i), d being the layer's optical thickness. Near grazing views
/// the first quotient, d p / (4 pi cos_o), is limited to 1, so f is reciprocal only away from
/// there, and photons get its adjoint. As in the paper more light comes back at grazing angles than
/// arrives. In LuxRender's image of lux-conformance's material-velvet most rings of the sphere are
/// within 5 % of this in red and blue, some within 10 %, which is about its noise; its green is 4
/// to 21 % lower (of a purple: probably its spectra).
class AsperityBsdf final : public Bsdf {
  public:
    /// `thickness`: optical, along the normal.
    AsperityBsdf(const Rgb& kd, const FibrePhase& phase, float thickness, const Vec3& ng,
                 const Vec3& ns)
        : kd_(kd), phase_(phase), thickness_(thickness), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    Rgb kd_;
    FibrePhase phase_;
    float thickness_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
