// Below which radius single precision leaves nothing to estimate: photons and visible points stand
// on a lattice, and a disc between its points would count none or a whole cell's photons.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "eye/eye_pass.h"
#include "radii/constants.h"

namespace aips {

/// Least radius over the scene's diagonal, beside that of coordinates.
inline constexpr double kLeastRadiusShare = 1e-9;

/// The smallest radii of a scene. They follow the coordinates of the place, not the scene's extent:
/// what stands near the origin of a wide ground can be sharp.
class RadiusFloor {
  public:
    explicit RadiusFloor(const Scene& scene)
        : least_(kLeastRadiusShare * double(scene.bounds().diagonal())) {
        if (!std::isfinite(least_)) least_ = 0;
    }

    /// Nowhere smaller than this, scene units; 0 where the scene has no finite bounds.
    double least() const { return least_; }
    /// Around a visible point.
    float at(Vec3 position) const {
        const float largest =
            std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
        return std::max(kShareOfCoordinate * largest, float(least_));
    }

  private:
    /// Two steps between floats, where these are widest.
    static constexpr float kShareOfCoordinate = 2 * 0x1p-23f;

    double least_;
};

/// For each visible point of `image` the greater of `radius` and the floor there; left empty where
/// `radius` does for all.
void raise_to_floor(const EyeImage& image, const RadiusFloor& floor, float radius,
                    std::vector<float>& radii);

}  // namespace aips
