// Analytic shapes, intersected in double precision in their own space.
#pragma once

#include "affine_map.h"
#include "lxs/scene/geometry.h"
#include "revolution_roots.h"

namespace lxs {

/// A point of a quadric in the space of its enclosing object.
struct QuadricPoint {
    Imath::V3d p;
    Imath::V3d normal;     ///< unit; the side that dpdu x dpdv points to
    Imath::V3d dpdu;       ///< zero at a pole
    Imath::V3d dpdv{0.0};  ///< zero at a pole, a disk's centre and the vertex of a paraboloid
    Vec2 uv;
};

/// An analytic shape, cut as declared, ready to be traced. Coordinates: u = phi / phi_max; v runs
/// from z_min to z_max by polar angle (sphere), from the rim inwards (disk) or along the profile
/// (others), as in LuxRender.
class QuadricShape {
  public:
    explicit QuadricShape(const Quadric& quadric);

    /// Nearest intersection in [t_min, t_max]. The direction need not be of unit length. Errors
    /// come from the origin's own rounding only: all is computed in double precision, with the
    /// cancellation-free root of Haines et al. 2019 (Ray Tracing Gems, chapter 7).
    bool intersect(const Vec3& origin, const Vec3& direction, float t_min, float t_max,
                   float& t) const;
    /// What of a point is asked for: position and normal, or tangents and coordinates too.
    enum class Parts : std::uint8_t { Place, All };
    /// The point of the surface nearest to origin + t * direction, for a `t` from `intersect`.
    QuadricPoint point(const Imath::V3d& origin, const Imath::V3d& direction, float t,
                       Parts parts = Parts::All) const;
    /// Box in the space of the enclosing object, rounded outwards.
    Bounds bounds() const;
    /// Bound of the rounding of double precision in `point` and `intersect`, as a length.
    double rounding() const { return rounding_; }

  private:
    RayRoots roots(const Imath::V3d& origin, const Imath::V3d& direction) const;
    bool keeps(const Imath::V3d& p) const;
    QuadricPoint sphere_point(Imath::V3d p, Parts parts) const;
    QuadricPoint disk_point(Imath::V3d p, Parts parts) const;
    QuadricPoint revolution_point(const Imath::V3d& p) const;
    void set_up(const Sphere& sphere);
    void set_up(const Disk& disk);

    AffineMap map_;                                  ///< from the shape's own space
    std::optional<SurfaceOfRevolution> revolution_;  ///< neither sphere nor disk
    std::optional<RevolutionRoots> revolution_roots_;
    bool is_sphere_ = false;
    bool mirrored_ = false;
    bool whole_ = false;  ///< a full sphere
    double radius_ = 1, inner_radius_ = 0;
    double z_min_ = 0, z_max_ = 0;  ///< of the sphere or profile; of a disk: its height, twice
    double phi_max_ = 0;
    double theta_min_ = 0, theta_range_ = 1;  ///< polar angle at z_min; from there to z_max
    double ring_ = 1;                         ///< width of the disk
    double rounding_ = 0;
};

}  // namespace lxs
