// A point on a yarn of woven cloth: the fibres at its surface, and what is scattered below them.
// Sources: Irawan & Marschner 2012, "Specular Reflection from Woven Cloth" (yarns of fibres that
// mirror light into cones, Seeliger's attenuation); Seeliger 1888, by way of that paper.
#pragma once

#include "fibre_lobe.h"
#include "lxs/sdk/bsdf.h"
#include "lxs/sdk/frame.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

/// A place on a yarn, in the coordinates of the shading frame (z is the cloth's normal).
struct YarnPoint {
    Vec3 normal{0, 0, 1};   ///< of the yarn's surface, unit, z >= 0
    Vec3 tangent{1, 0, 0};  ///< of the fibres there, unit, perpendicular to `normal`
    FibreLobe fibres;
};

/// f = Kd / pi + Ks p(wo, wi) (m_o / c_o) (m_i / c_i) (1 + m_o m_i) / (m_o + m_i), with the fibres'
/// phase function p, the cosines c to the cloth's normal, and m the area that a direction sees of
/// the yarn's surface per area of cloth: the cosine to the yarn's normal over that normal's z, at
/// most c, since neighbours hide the rest. 1 / (m_o + m_i) is Seeliger's law for one scattering in
/// dense fibres. The factor 1 + m_o m_i stands for further ones, up to what is certain not to give
/// out more than comes in: m_i (1 + m_o m_i) <= m_o + m_i since m_i <= 1, so that f c_i is at most
/// Ks p, whose integral is Ks. Reciprocal. Both sides of the cloth look alike.
class WovenBsdf final : public Bsdf {
  public:
    /// In every channel kd + ks <= 1.
    WovenBsdf(const Rgb& kd, const Rgb& ks, const YarnPoint& yarn, const Frame& frame,
              const Vec3& ng)
        : kd_(kd), ks_(ks), yarn_(yarn), frame_(frame), ng_(ng), black_base_(is_black(kd)) {}

    LobeMask lobes() const override { return black_base_ ? kGlossy : kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// m of a local direction with z > 0.
    float seen_area(const Vec3& w) const;
    /// Probability of the fibres, and of the diffuse part, seen from the local direction `wo`.
    struct Choice {
        float fibres = 0, base = 0;
    };
    Choice choose(const Vec3& wo, LobeMask mask) const;
    float density(const Choice& choice, const HalfVector& pair) const;
    Rgb value(const HalfVector& pair, LobeMask mask) const;

    Rgb kd_, ks_;
    YarnPoint yarn_;
    Frame frame_;
    Vec3 ng_;
    bool black_base_;
};

}  // namespace lxs::shading
