// Microfacet distribution of Trowbridge and Reitz 1975 (GGX) with Smith's height-correlated masking
// and shadowing: what pbrt, Mitsuba and Cycles have.
// Sources: Walter et al. 2007; Heitz 2014, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs"; Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical
// Caps".
#pragma once

#include "directions.h"

namespace lxs::shading {

/// Facet normals h around local +z of roughness alpha along x and y.
class TrowbridgeReitz {
  public:
    /// `alpha_x`, `alpha_y`: limited to [0.006, 1] as Schlick's facets are.
    TrowbridgeReitz(float alpha_x, float alpha_y);

    /// alpha^2, as SchlickDistribution has it: without grain both have the same D.
    float roughness() const { return alpha_x_ * alpha_y_; }
    bool grained() const { return alpha_x_ != alpha_y_; }
    /// D(h) for h.z > 0; integrates with h.z to 1.
    float density(const Vec3& h) const {
        const float x = h.x / alpha_x_, y = h.y / alpha_y_, d = x * x + y * y + h.z * h.z;
        return kInvPi / (alpha_x_ * alpha_y_ * d * d);
    }
    /// Smith's G / |cos_o cos_i| of two directions, on either side, correlated by height (Heitz
    /// 2014, equations 72 and 99), written so that nothing overflows.
    float shadowing_over_cosines(const Vec3& wo, const Vec3& wi) const {
        return 2 / (std::abs(wo.z) * stretched(wi) + std::abs(wi.z) * stretched(wo));
    }
    /// Share of the facets that `wo` sees which `wi` sees too.
    float seen_too(const Vec3& wo, const Vec3& wi) const {
        return shadowing_over_cosines(wo, wi) * std::abs(wi.z) * 0.5f *
               (std::abs(wo.z) + stretched(wo));
    }
    /// Draws a facet among those that `wo`, wo.z > 0, sees.
    Vec3 sample_visible(const Vec3& wo, const Vec2& u) const;
    /// Density of sample_visible per steradian of h, over wo.h.
    float visible_density(const Vec3& wo, const Vec3& h) const {
        return 2 * density(h) / (wo.z + stretched(wo));
    }

  private:
    /// Length of `w` stretched as the facets are.
    float stretched(const Vec3& w) const {
        const float x = alpha_x_ * w.x, y = alpha_y_ * w.y;
        return std::sqrt(x * x + y * y + w.z * w.z);
    }

    float alpha_x_, alpha_y_;
};

}  // namespace lxs::shading
