// How the intensity of a small piece of a surface depends on direction: a latitude-longitude map
// around its normal, of which only what lies in front of the surface shines.
#pragma once

#include "emission_profile.h"

namespace lxs {

/// Directions are in the surface's own frame, z along the normal. The map tells intensities, as
/// photometric files do: a piece of area dA sends L * s * map * dA along a direction, so its
/// radiance is L * s * map / cosine, s being what makes its flux that of a diffuse surface of the
/// same L. docs/reference/shading.md says why.
class FrontProfile {
  public:
    /// `map` is of all directions, +z in its top row.
    explicit FrontProfile(const LatLongMap& map);

    /// Radiance towards the unit vector `w`, relative to L.
    Rgb radiance(const Vec3& w) const;
    /// Draws a direction about in proportion to the intensity; its density per steradian, 0:
    /// nothing drawn.
    float sample(const Vec2& u, Vec3& w) const;
    /// Inverse of sample, in [0, 1)^2; false where nothing is drawn.
    bool coordinates(const Vec3& w, Vec2& u) const;
    /// Integral of radiance times cosine over all directions: of luminance pi, as for a diffuse
    /// surface; 0 if the map is dark in front.
    const Rgb& flux() const { return flux_; }

  private:
    SphereProfile sphere_;  ///< behind the surface it goes on as at the horizon
    Rgb flux_{0.0f};
    float scale_ = 0;  ///< s
};

}  // namespace lxs
