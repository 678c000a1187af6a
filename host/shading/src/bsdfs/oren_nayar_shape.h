// How the roughness of a diffuse surface changes its look.
// Source: Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", qualitative model
// (equation 30).
#pragma once

#include <algorithm>
#include <cmath>

#include "directions.h"
#include "lxs/sdk/types.h"

namespace lxs::shading {

/// f * pi / Kd of a surface of V-cavities; 1 everywhere if it is smooth.
class OrenNayarShape {
  public:
    /// `sigma`: standard deviation of the facets' slope angle, radians, >= 0.
    explicit OrenNayarShape(float sigma) {
        const float sigma2 = sigma * sigma;
        a_ = 1 - sigma2 / (2 * (sigma2 + 0.33f));
        b_ = 0.45f * sigma2 / (sigma2 + 0.09f);
    }
    /// For directions on one side of the plane with normal `ns`; one of two on different sides
    /// counts as its mirror image in that plane.
    float operator()(const Vec3& wo, const Vec3& wi, const Vec3& ns) const {
        const float cos_o = wo.dot(ns), cos_i = wi.dot(ns);
        // sin(alpha) tan(beta) cos(phi_i - phi_o) without an angle: the tangential parts' product
        // over the larger cosine.
        const float tangential = std::max(0.0f, wo.dot(wi) - cos_o * cos_i);
        // Finite where both directions graze the surface, too.
        const float larger = std::max({std::abs(cos_o), std::abs(cos_i), kMinCosine});
        return a_ + b_ * tangential / larger;
    }
    /// Approximate mean over incoming directions, at most 1.
    float mean() const {
        // The second term adds between 0 and about half of b; its middle is near enough.
        return std::min(1.0f, a_ + 0.25f * b_);
    }

  private:
    float a_, b_;
};

}  // namespace lxs::shading
