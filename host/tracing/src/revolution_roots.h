// Where straight lines meet surfaces of revolution that extend beyond their cuts.
#pragma once

#include "lxs/scene/surface_of_revolution.h"

namespace lxs {

/// Parameters of a line's intersections, ascending.
struct RayRoots {
    double t[4] = {};
    int count = 0;
};

/// The implicit equation of a cylinder, cone, hyperboloid, paraboloid or torus in its own space.
class RevolutionRoots {
  public:
    /// `quadric` is a shape that SurfaceOfRevolution::of knows.
    explicit RevolutionRoots(const Quadric& quadric);
    /// Roots along origin + t * direction, which need not be of unit length. They are taken from
    /// the line's point nearest to the shape's middle, so that distant origins cost no digits.
    RayRoots along(const Imath::V3d& origin, const Imath::V3d& direction) const;

  private:
    /// x^2 + y^2 = c0 + 2 c1 z + c2 z^2
    struct Profile {
        double c0, c1, c2;
    };
    struct Tube {
        double major, minor;
    };
    static RayRoots along(const Profile& s, const Imath::V3d& o, const Imath::V3d& d);
    static RayRoots along(const Tube& s, const Imath::V3d& o, const Imath::V3d& d);

    std::variant<Profile, Tube> shape_;
    double middle_ = 0;  ///< z of the shape's middle, where z = 0 of the equation is
};

}  // namespace lxs
