// Intersection and surface coordinates of analytic shapes.
#include "quadric_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lxs {
namespace {

using Imath::V3d;

constexpr double kHalfTurn = std::numbers::pi;  // radians
constexpr double kDoubleRoundoff = 0x1p-53;

double length(const V3d& v) {
    return std::sqrt(v.dot(v));  // V3d::length() isn't inlined
}

double azimuth(const V3d& p) {
    const double phi = std::atan2(p.y, p.x);
    return phi < 0 ? phi + 2 * kHalfTurn : phi;
}

double sweep(double degrees) {
    constexpr double kSmallestAngle = 1e-9;  // keeps u finite
    return std::clamp(degrees * (kHalfTurn / 180), kSmallestAngle, 2 * kHalfTurn);
}

double polar_angle(double z, double radius) {
    return std::acos(std::clamp(z / radius, -1.0, 1.0));
}

float below(double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

}  // namespace

QuadricShape::QuadricShape(const Quadric& quadric)
    : map_(quadric.to_world),
      revolution_(SurfaceOfRevolution::of(quadric)),
      mirrored_(map_.mirrors()) {
    if (revolution_) {
        revolution_roots_.emplace(quadric);
        radius_ = revolution_->reach();
        z_min_ = revolution_->z_min();
        z_max_ = revolution_->z_max();
        phi_max_ = revolution_->phi_max();
    } else if (const auto* sphere = std::get_if<Sphere>(&quadric.shape)) {
        set_up(*sphere);
    } else {
        set_up(std::get<Disk>(quadric.shape));
    }
    const double reach = std::max({radius_, std::abs(z_min_), std::abs(z_max_)});
    const double size =
        (map_.axis(0).length() + map_.axis(1).length() + map_.axis(2).length()) * reach +
        map_.translation().length();
    rounding_ = 32 * kDoubleRoundoff * size;
}

void QuadricShape::set_up(const Sphere& sphere) {
    is_sphere_ = true;
    radius_ = sphere.radius;
    z_min_ = std::max(-radius_, static_cast<double>(sphere.z_min));
    z_max_ = std::min(radius_, static_cast<double>(sphere.z_max));
    phi_max_ = sweep(sphere.phi_max);
    whole_ = z_min_ <= -radius_ && z_max_ >= radius_ && sphere.phi_max >= 360;
    theta_min_ = polar_angle(z_min_, radius_);
    const double range = polar_angle(z_max_, radius_) - theta_min_;
    if (range != 0) theta_range_ = range;
}

void QuadricShape::set_up(const Disk& disk) {
    radius_ = disk.radius;
    inner_radius_ = disk.inner_radius;
    z_min_ = z_max_ = disk.height;
    phi_max_ = sweep(disk.phi_max);
    if (radius_ > inner_radius_) ring_ = radius_ - inner_radius_;
}

RayRoots QuadricShape::roots(const V3d& o, const V3d& d) const {
    if (revolution_) return revolution_roots_->along(o, d);
    if (!is_sphere_) {
        if (d.z == 0) return {};
        return {{(z_min_ - o.z) / d.z}, 1};
    }
    const double a = d.dot(d);
    const double b = -o.dot(d);          // half of the linear coefficient, negated
    const V3d offset = o + d * (b / a);  // the line's point nearest to the centre
    const double discriminant = radius_ * radius_ - offset.dot(offset);
    if (!(discriminant >= 0) || a == 0) return {};
    const double distance = length(o);
    const double c = (distance - radius_) * (distance + radius_);
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    if (q == 0) return {{0}, 1};  // the origin is where the line touches the sphere
    const double t0 = c / q, t1 = q / a;
    return {{std::min(t0, t1), std::max(t0, t1)}, 2};
}

bool QuadricShape::keeps(const V3d& p) const {
    if (whole_) return true;
    if (revolution_) {
        constexpr double kMargin = 1e-12;  // tips and seams stay closed in spite of rounding
        const double slack = 1e3 * kMargin * (z_max_ - z_min_);
        if (p.z < z_min_ - slack || p.z > z_max_ + slack) return false;  // a cone's other half
        const Imath::V2d at = revolution_->coordinates(p);
        return at.y >= -kMargin && at.y <= 1 + kMargin &&
               (phi_max_ >= 2 * kHalfTurn || at.x <= phi_max_);
    }
    if (is_sphere_) {
        // Sections of the sphere at its poles keep the poles in spite of rounding.
        if (p.z < z_min_ && z_min_ > -radius_) return false;
        if (p.z > z_max_ && z_max_ < radius_) return false;
    } else {
        const double r2 = p.x * p.x + p.y * p.y;
        if (r2 > radius_ * radius_ || r2 < inner_radius_ * inner_radius_) return false;
    }
    return phi_max_ >= 2 * kHalfTurn || azimuth(p) <= phi_max_;
}

bool QuadricShape::intersect(const Vec3& origin, const Vec3& direction, float t_min, float t_max,
                             float& t) const {
    const V3d o = map_.inverse_point(V3d(origin));
    const V3d d = map_.inverse_vector(V3d(direction));
    const RayRoots found = roots(o, d);
    for (int i = 0; i < found.count; ++i) {
        const auto candidate = static_cast<float>(found.t[i]);
        if (!(candidate >= t_min && candidate <= t_max)) continue;
        if (!keeps(o + d * found.t[i])) continue;
        t = candidate;
        return true;
    }
    return false;
}

QuadricPoint QuadricShape::point(const V3d& origin, const V3d& direction, float t,
                                 Parts parts) const {
    const V3d p = map_.inverse_point(origin + direction * static_cast<double>(t));
    QuadricPoint point = revolution_  ? revolution_point(p)
                         : is_sphere_ ? sphere_point(p, parts)
                                      : disk_point(p, parts);
    point.p = map_.point(point.p);
    if (parts == Parts::All) {
        point.dpdu = map_.vector(point.dpdu);
        point.dpdv = map_.vector(point.dpdv);
    }
    point.normal = map_.normal(point.normal);
    point.normal *= (mirrored_ ? -1 : 1) / length(point.normal);
    return point;
}

QuadricPoint QuadricShape::sphere_point(V3d p, Parts parts) const {
    const double distance = length(p);
    const V3d normal = distance > 0 ? p * (1 / distance) : V3d(0, 0, 1);
    p = normal * radius_;
    QuadricPoint point;
    point.p = p;
    point.normal = normal;
    if (parts == Parts::Place) return point;
    // Of u and v: LuxRender's image of a bump map on a ball has these (texture-bump,
    // docs/measured/conformance.md).
    point.dpdu = V3d(-p.y, p.x, 0) * phi_max_;
    const double rho = std::hypot(p.x, p.y);
    if (rho > 0) point.dpdv = V3d(p.z * p.x / rho, p.z * p.y / rho, -rho) * theta_range_;
    const double v = (polar_angle(p.z, radius_) - theta_min_) / theta_range_;
    point.uv = Vec2(static_cast<float>(std::min(1.0, azimuth(p) / phi_max_)),
                    static_cast<float>(std::clamp(v, 0.0, 1.0)));
    return point;
}

QuadricPoint QuadricShape::disk_point(V3d p, Parts parts) const {
    p.z = z_min_;
    QuadricPoint point;
    point.p = p;
    point.normal = V3d(0, 0, 1);
    if (parts == Parts::Place) return point;
    point.dpdu = V3d(-p.y, p.x, 0) * phi_max_;
    const double r = std::hypot(p.x, p.y);
    if (r > 0) point.dpdv = V3d(p.x, p.y, 0) * (-ring_ / r);
    const double v = 1 - (r - inner_radius_) / ring_;
    point.uv = Vec2(static_cast<float>(std::min(1.0, azimuth(p) / phi_max_)),
                    static_cast<float>(std::clamp(v, 0.0, 1.0)));
    return point;
}

QuadricPoint QuadricShape::revolution_point(const V3d& p) const {
    const Imath::V2d at = revolution_->coordinates(p);
    const double v = std::clamp(at.y, 0.0, 1.0);
    const RevolutionPoint found = revolution_->at(at.x, v);
    QuadricPoint point;
    point.p = found.p;
    point.normal = found.normal;
    point.dpdu = V3d(-found.p.y, found.p.x, 0) * phi_max_;
    point.dpdv = found.dpdv;
    point.uv = Vec2(static_cast<float>(std::min(1.0, at.x / phi_max_)), static_cast<float>(v));
    return point;
}

Bounds QuadricShape::bounds() const {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
        const double ax = map_.axis(0)[k], ay = map_.axis(1)[k], az = map_.axis(2)[k];
        // A cylinder around the axis between z_min and z_max; for a sphere its ellipsoid too.
        const double half = radius_ * std::hypot(ax, ay) + std::abs(az) * (z_max_ - z_min_) / 2;
        double low = az * (z_min_ + z_max_) / 2 - half, high = low + 2 * half;
        if (is_sphere_) {
            const double reach = radius_ * std::hypot(ax, ay, az);
            low = std::max(low, -reach);
            high = std::min(high, reach);
        }
        const double center = map_.translation()[k];
        box.min[k] = below(center + low - rounding_);
        box.max[k] = above(center + high + rounding_);
    }
    return box;
}

}  // namespace lxs
