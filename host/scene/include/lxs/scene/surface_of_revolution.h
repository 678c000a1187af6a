// Cylinders, cones, hyperboloids, paraboloids and tori by their surface coordinates: what tracing
// and lights both need of them.
#pragma once

#include <optional>
#include <variant>

#include "lxs/scene/geometry.h"

namespace lxs {

/// A point at (phi, v): azimuth in radians and position along the profile in [0, 1].
struct RevolutionPoint {
    Imath::V3d p;
    Imath::V3d normal;     ///< unit, the side that dp/dphi x dp/dv points to
    Imath::V3d dpdv{0.0};  ///< zero at the vertex of a paraboloid, where it is not finite
    double area = 0;       ///< |dp/dphi x dp/dv|: area per radian and unit of v
};

/// A surface of revolution about the z axis in its own space, in double precision.
class SurfaceOfRevolution {
  public:
    explicit SurfaceOfRevolution(const RevolvedSegment& shape);
    explicit SurfaceOfRevolution(const Paraboloid& shape);
    explicit SurfaceOfRevolution(const Torus& shape);
    /// None for shapes of other kinds.
    static std::optional<SurfaceOfRevolution> of(const Quadric& quadric);

    RevolutionPoint at(double phi, double v) const;
    /// (phi, v) of the surface point nearest to `p` or about so; phi in [0, 2 pi) may be beyond
    /// phi_max, v is not clamped.
    Imath::V2d coordinates(const Imath::V3d& p) const;

    /// v for a uniform `x` in [0, 1], so that points at v have about equal density per area: exact
    /// for cylinders, cones and paraboloids. `density` is dx/dv.
    double v_of(double x, double& density) const;
    /// Inverse of v_of, and its density.
    double x_of(double v, double& density) const;

    double phi_max() const { return phi_max_; }  ///< radians, above 0
    double reach() const { return reach_; }      ///< largest distance from the z axis
    double z_min() const { return z_min_; }
    double z_max() const { return z_max_; }

  private:
    struct Segment {
        Imath::V3d start, along;  ///< along = end - start
        double rho[2];            ///< distances of the ends from the axis
        bool upright;             ///< lies in a half-plane that the axis bounds
        Imath::V3d rim() const { return rho[0] >= rho[1] ? start : start + along; }
    };
    struct Bowl {
        double k;  ///< radius^2 / height: x^2 + y^2 = k z
        double z_min, range;
    };
    struct Tube {
        double major, minor, theta_min, range;  ///< angles in radians
    };
    static RevolutionPoint at(const Segment& s, double cosine, double sine, double v);
    static RevolutionPoint at(const Bowl& s, double cosine, double sine, double v);
    static RevolutionPoint at(const Tube& s, double cosine, double sine, double v);
    static Imath::V2d coordinates(const Segment& s, const Imath::V3d& p);
    static Imath::V2d coordinates(const Bowl& s, const Imath::V3d& p);
    static Imath::V2d coordinates(const Tube& s, const Imath::V3d& p);

    std::variant<Segment, Bowl, Tube> profile_;
    double phi_max_ = 0;
    double reach_ = 0, z_min_ = 0, z_max_ = 0;
};

}  // namespace lxs
