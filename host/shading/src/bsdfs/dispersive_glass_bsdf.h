// Smooth dielectric interface that bends each wavelength its own way.
#pragma once

#include "specular_bsdf.h"
#include "thin_film.h"

namespace lxs::shading {

/// Reflection keeps all components of the light; refraction goes on with one of them, chosen
/// uniformly among those that the path still carries, in its own direction.
class DispersiveGlassBsdf final : public SpecularBsdf {
  public:
    /// `eta`: index behind the surface (-ng) / index before it (+ng), by component; `component` of
    /// the arriving path (Ray::component).
    DispersiveGlassBsdf(const Rgb& kr, const Rgb& kt, const Rgb& eta, const ThinFilm& film,
                        std::int8_t component, const Vec3& ng, const Vec3& ns)
        : kr_(kr), kt_(kt), eta_(eta), film_(film), component_(component), ng_(ng), ns_(ns) {}

    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    float first_specular(const Vec3& wo) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// Share reflected, by component; black for those that the path doesn't carry.
    Rgb reflected(const Vec3& wo) const;
    Rgb transmitted(const Vec3& wo) const;
    /// 1 for components that the path carries, else 0.
    Rgb carried() const;

    Rgb kr_, kt_, eta_;
    ThinFilm film_;
    std::int8_t component_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
