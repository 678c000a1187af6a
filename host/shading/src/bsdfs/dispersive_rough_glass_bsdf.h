// Rough dielectric interface that bends each wavelength its own way.
// Source: Wilkie et al. 2014, "Hero wavelength spectral sampling": a direction drawn for one
// wavelength is weighed for all by the mean of their densities.
#pragma once

#include "rough_glass_bsdf.h"

namespace lxs::shading {

/// Each component of the light meets the same facets with its own index. A facet scatters into a
/// whole lobe, so that one direction serves all components that the path carries, unlike smooth
/// glass, where they part for good: it is drawn for one of them, chosen uniformly, and its density
/// is the mean over them. With facets so smooth that the lobes don't overlap, one is left.
class DispersiveRoughGlassBsdf final : public Bsdf {
  public:
    /// `eta`: index behind the surface / index before it, by component, none of them 1;
    /// `component` of the arriving path (Ray::component).
    DispersiveRoughGlassBsdf(const Rgb& kr, const Rgb& kt, const Rgb& eta, std::int8_t component,
                             const MicrofacetLobe& facets)
        : kr_(kr), kt_(kt), eta_(eta), component_(component), facets_(facets) {}

    LobeMask lobes() const override { return kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// The components that the path carries: [first, end).
    int first() const { return component_ == kAllComponents ? 0 : component_; }
    int end() const { return component_ == kAllComponents ? 3 : component_ + 1; }
    /// The surface as component `c` sees it.
    RoughGlassBsdf of_component(int c) const {
        return RoughGlassBsdf(Rgb(kr_[c]), Rgb(kt_[c]), eta_[c], facets_);
    }

    Rgb kr_, kt_, eta_;
    std::int8_t component_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
