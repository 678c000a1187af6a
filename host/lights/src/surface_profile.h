// A profile of intensities as it lies on the surface of an area light.
#pragma once

#include <memory>

#include "front_profile.h"
#include "lxs/sdk/frame.h"

namespace lxs {

/// Vertical angle 0 is along the normal, azimuth 0 along the x axis of the shape's space, made
/// tangent to the surface (the y axis where x is nearly the normal): the profile turns, and is
/// mirrored, with the shape and its instances. Directions are unit vectors in world space.
class SurfaceProfile {
  public:
    /// `to_world` leads from the space in which the shape's statement stands.
    SurfaceProfile(std::shared_ptr<const FrontProfile> front, const Matrix& to_world);

    /// Radiance relative to L towards `w`, from a surface whose normal is `n`.
    Rgb radiance(const Vec3& n, const Vec3& w) const;
    /// FrontProfile::sample and its inverse.
    float sample(const Vec3& n, const Vec2& u, Vec3& w) const;
    bool coordinates(const Vec3& n, const Vec3& w, Vec2& u) const;
    const Rgb& flux() const { return front_->flux(); }

  private:
    Frame frame(const Vec3& n) const;

    std::shared_ptr<const FrontProfile> front_;
    Vec3 x_, y_;  ///< unit axes of the shape's space
    bool mirrored_ = false;
};

}  // namespace lxs
