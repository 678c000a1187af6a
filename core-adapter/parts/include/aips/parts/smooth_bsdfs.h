// Bsdfs in closed form: matte, mirror, glass. All are built in dropped memory: trivially
// destructible.
#pragma once

#include "aips/adapter/bsdf.h"

namespace aips {

/// Common part: normals, and which side two directions lie on.
class OrientedBsdf : public Bsdf {
  protected:
    /// Unit, in one hemisphere.
    OrientedBsdf(Vec3 geometric_normal, Vec3 shading_normal)
        : ng_(geometric_normal), ns_(shading_normal) {}
    ~OrientedBsdf() = default;

    bool same_side(Vec3 a, Vec3 b) const { return (dot(a, ng_) > 0) == (dot(b, ng_) > 0); }
    Vec3 normal_towards(Vec3 w) const { return dot(w, ng_) > 0 ? ns_ : -ns_; }
    Vec3 reflect(Vec3 wo) const { return ns_ * (2 * dot(wo, ns_)) - wo; }

    Vec3 ng_, ns_;
};

/// f = kd / pi on both sides.
class LambertBsdf final : public OrientedBsdf {
  public:
    LambertBsdf(Vec3 geometric_normal, Vec3 shading_normal, Rgb kd)
        : OrientedBsdf(geometric_normal, shading_normal), kd_(kd) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override;
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override;
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kDiffuse ? kd_ : Rgb{}; }
    bool lambertian(Rgb& kd) const override {
        kd = kd_;
        return true;
    }

  private:
    Rgb kd_;
};

/// Reflects `kr` of what arrives, on both sides.
class MirrorBsdf final : public OrientedBsdf {
  public:
    MirrorBsdf(Vec3 geometric_normal, Vec3 shading_normal, Rgb kr)
        : OrientedBsdf(geometric_normal, shading_normal), kr_(kr) {}

    LobeMask lobes() const override { return kSpecular; }
    Rgb evaluate(Vec3, Vec3, Transport, LobeMask) const override { return {}; }
    float pdf(Vec3, Vec3, LobeMask) const override { return 0; }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kSpecular ? kr_ : Rgb{}; }

  private:
    Rgb kr_;
};

/// Smooth dielectric: Fresnel decides between reflection and refraction.
class GlassBsdf final : public OrientedBsdf {
  public:
    /// `index`: refractive index behind the surface over that before it.
    GlassBsdf(Vec3 geometric_normal, Vec3 shading_normal, float index)
        : OrientedBsdf(geometric_normal, shading_normal), index_(index) {}

    LobeMask lobes() const override { return kSpecular; }
    Rgb evaluate(Vec3, Vec3, Transport, LobeMask) const override { return {}; }
    float pdf(Vec3, Vec3, LobeMask) const override { return 0; }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    float first_specular(Vec3 wo) const override;
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kSpecular ? kWhite : Rgb{}; }

  private:
    /// Incident over transmitted.
    float eta_from(Vec3 wo) const { return dot(wo, ng_) > 0 ? 1 / index_ : index_; }

    float index_;
};

}  // namespace aips
