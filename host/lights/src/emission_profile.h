// How the intensity of a light at a point depends on direction: an image of all directions, or one
// that is projected.
#pragma once

#include "latlong_map.h"
#include "lxs/sdk/frame.h"
#include "rotation.h"

namespace lxs {

class EmissionProfile {
  public:
    virtual ~EmissionProfile() = default;
    /// Share of the light's intensity along the unit vector `w`, world space; >= 0.
    virtual Rgb at(const Vec3& w) const = 0;
    /// Draws a direction about in proportion to `at`; its density per steradian, 0: nothing drawn.
    virtual float sample(const Vec2& u, Vec3& w) const = 0;
    /// Inverse of sample, in [0, 1)^2; false where nothing is drawn.
    virtual bool coordinates(const Vec3& w, Vec2& u) const = 0;
    /// Integral of `at` over all directions.
    virtual Rgb integral() const = 0;
};

/// A latitude-longitude map around the light's +z.
class SphereProfile final : public EmissionProfile {
  public:
    SphereProfile(const Rotation& rotation, LatLongMap map);
    /// Draws directions by `importance`, which need not follow all of the map.
    SphereProfile(const Rotation& rotation, LatLongMap map, Piecewise2D importance);
    Rgb at(const Vec3& w) const override;
    float sample(const Vec2& u, Vec3& w) const override;
    bool coordinates(const Vec3& w, Vec2& u) const override;
    Rgb integral() const override { return map_.fluence(); }

  private:
    Rotation rotation_;
    LatLongMap map_;
    Piecewise2D importance_;
};

/// An image projected into a pyramid whose shorter side subtends an angle, which lights a screen
/// across its axis as the image is: its intensity is the image over LuxRender's area of the screen
/// and over the cubed cosine from the axis. That area is the screen's at distance 1 unless the
/// image is wider than high: then it is that over the square of width over height.
class ScreenProfile final : public EmissionProfile {
  public:
    /// `axes`: n is the axis, s the direction of the image's rows, t that of its columns, from the
    /// top row on; `fov` in radians. `plain`: the image's values are the emission itself, as in
    /// pbrt.
    ScreenProfile(const Frame& axes, LatLongMap image, float fov, bool plain);
    Rgb at(const Vec3& w) const override;
    float sample(const Vec2& u, Vec3& w) const override;
    bool coordinates(const Vec3& w, Vec2& u) const override;
    Rgb integral() const override { return integral_; }

  private:
    /// Place in the image of the world direction `w`; false if it misses the image.
    bool image_place(const Vec3& w, Vec2& st) const;
    Vec3 local_direction(const Vec2& st) const;

    Frame axes_;
    LatLongMap image_;
    Vec2 half_{1.0f};  ///< half the image's sides at distance 1
    float area_ = 1;   ///< LuxRender's, see above
    bool plain_ = false;
    Piecewise2D importance_;
    Rgb integral_{0.0f};
};

}  // namespace lxs
