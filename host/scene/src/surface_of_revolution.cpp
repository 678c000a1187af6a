// Points, coordinates and area densities of surfaces of revolution.
#include "lxs/scene/surface_of_revolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lxs {
namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRadians = std::numbers::pi / 180;

double phi_limit(float degrees) {
    constexpr double kSmallestAngle = 1e-9;  // keeps coordinates finite
    return std::clamp(degrees * kRadians, kSmallestAngle, kTurn);
}

double angle_from_zero(double y, double x) {
    const double angle = std::atan2(y, x);
    return angle < 0 ? angle + kTurn : angle;
}

/// p / |p|, or `fallback` for a vector of length zero.
V3d unit(const V3d& p, const V3d& fallback) {
    const double length = std::sqrt(p.dot(p));
    return length > 0 ? p * (1 / length) : fallback;
}

/// Position in [0, 1] of a distribution whose density goes linearly from a to b.
double linear_cdf(double a, double b, double v) {
    return v * (2 * a + (b - a) * v) / (a + b);
}

double linear_quantile(double a, double b, double x) {
    // Root of linear_cdf = x in the form without cancellation.
    const double root = std::sqrt(std::max(0.0, a * a + (b * b - a * a) * x));
    return a + root > 0 ? std::min(1.0, (a + b) * x / (a + root)) : 0.0;
}

}  // namespace

SurfaceOfRevolution::SurfaceOfRevolution(const RevolvedSegment& shape)
    : phi_max_(phi_limit(shape.phi_max)) {
    const V3d start(shape.start), end(shape.end);
    const double rho[2] = {std::hypot(start.x, start.y), std::hypot(end.x, end.y)};
    const bool upright =
        start.x * end.y == start.y * end.x && start.x * end.x + start.y * end.y >= 0;
    profile_ = Segment{start, end - start, {rho[0], rho[1]}, upright};
    reach_ = std::max(rho[0], rho[1]);
    z_min_ = std::min(start.z, end.z);
    z_max_ = std::max(start.z, end.z);
}

SurfaceOfRevolution::SurfaceOfRevolution(const Paraboloid& shape)
    : phi_max_(phi_limit(shape.phi_max)),
      reach_(shape.radius),
      z_min_(shape.z_min),
      z_max_(shape.height) {
    const double radius = shape.radius;
    profile_ = Bowl{radius * radius / shape.height, z_min_, z_max_ - z_min_};
}

SurfaceOfRevolution::SurfaceOfRevolution(const Torus& shape)
    : phi_max_(phi_limit(shape.phi_max)),
      reach_(double(shape.major_radius) + shape.minor_radius),
      z_min_(-shape.minor_radius),
      z_max_(shape.minor_radius) {
    profile_ = Tube{shape.major_radius, shape.minor_radius, shape.theta_min * kRadians,
                    (double(shape.theta_max) - shape.theta_min) * kRadians};
}

std::optional<SurfaceOfRevolution> SurfaceOfRevolution::of(const Quadric& quadric) {
    if (const auto* segment = std::get_if<RevolvedSegment>(&quadric.shape))
        return SurfaceOfRevolution(*segment);
    if (const auto* bowl = std::get_if<Paraboloid>(&quadric.shape))
        return SurfaceOfRevolution(*bowl);
    if (const auto* torus = std::get_if<Torus>(&quadric.shape)) return SurfaceOfRevolution(*torus);
    return std::nullopt;
}

RevolutionPoint SurfaceOfRevolution::at(double phi, double v) const {
    const double cosine = std::cos(phi), sine = std::sin(phi);
    return std::visit([&](const auto& s) { return at(s, cosine, sine, v); }, profile_);
}

RevolutionPoint SurfaceOfRevolution::at(const Segment& s, double cosine, double sine, double v) {
    const auto turned = [&](const V3d& q) {
        return V3d(cosine * q.x - sine * q.y, sine * q.x + cosine * q.y, q.z);
    };
    RevolutionPoint point;
    point.p = turned(s.start + s.along * v);
    point.dpdv = turned(s.along);
    // At the tip of a cone the normal is that of the points near it.
    const V3d rim = turned(s.rim());
    const V3d radial =
        unit(V3d(point.p.x, point.p.y, 0), unit(V3d(rim.x, rim.y, 0), V3d(cosine, sine, 0)));
    const V3d across = V3d(-radial.y, radial.x, 0).cross(point.dpdv);
    point.normal = unit(across, V3d(0, 0, 1));
    point.area = std::hypot(point.p.x, point.p.y) * std::sqrt(across.dot(across));
    return point;
}

RevolutionPoint SurfaceOfRevolution::at(const Bowl& s, double cosine, double sine, double v) {
    const double z = s.z_min + v * s.range;
    const double rho = std::sqrt(std::max(0.0, s.k * z));
    RevolutionPoint point;
    point.p = V3d(rho * cosine, rho * sine, z);
    const V3d across(point.p.x, point.p.y, -s.k / 2);  // dp/dphi x dp/dz
    point.normal = unit(across, V3d(0, 0, -1));
    point.area = std::sqrt(across.dot(across)) * s.range;
    if (rho > 0) point.dpdv = V3d(cosine * s.k / (2 * rho), sine * s.k / (2 * rho), 1) * s.range;
    return point;
}

RevolutionPoint SurfaceOfRevolution::at(const Tube& s, double cosine, double sine, double v) {
    const double theta = s.theta_min + v * s.range;
    const double c = std::cos(theta), d = std::sin(theta);
    const double rho = s.major + s.minor * c;
    RevolutionPoint point;
    point.p = V3d(rho * cosine, rho * sine, s.minor * d);
    point.dpdv = V3d(-d * cosine, -d * sine, c) * (s.minor * s.range);
    point.normal = V3d(c * cosine, c * sine, d);
    point.area = std::abs(rho * s.minor * s.range);
    return point;
}

// Each coordinate is taken where the surface is steep against it: points that the rounding of a
// distance moved off the surface go back along its normal, or about so.
V2d SurfaceOfRevolution::coordinates(const V3d& p) const {
    return std::visit([&](const auto& s) { return coordinates(s, p); }, profile_);
}

V2d SurfaceOfRevolution::coordinates(const Segment& s, const V3d& p) {
    const V3d base = s.upright ? s.rim() : s.start + s.along * ((p.z - s.start.z) / s.along.z);
    const V2d turn(base.x * p.x + base.y * p.y, base.x * p.y - base.y * p.x);
    const double length = std::hypot(turn.x, turn.y);
    const double cosine = length > 0 ? turn.x / length : 1, sine = length > 0 ? turn.y / length : 0;
    const V3d back(cosine * p.x + sine * p.y, cosine * p.y - sine * p.x, p.z);
    return {angle_from_zero(sine, cosine), (back - s.start).dot(s.along) / s.along.dot(s.along)};
}

V2d SurfaceOfRevolution::coordinates(const Bowl& s, const V3d& p) {
    const double rho2 = p.x * p.x + p.y * p.y;
    const double z = 4 * rho2 < s.k * s.k ? rho2 / s.k : p.z;
    return {angle_from_zero(p.y, p.x), (z - s.z_min) / s.range};
}

V2d SurfaceOfRevolution::coordinates(const Tube& s, const V3d& p) {
    double rho = std::hypot(p.x, p.y), phi = angle_from_zero(p.y, p.x);
    const double outside = std::hypot(rho - s.major, p.z) - s.minor;
    const double across = std::hypot(rho + s.major, p.z) - s.minor;
    if (std::abs(across) < std::abs(outside)) {  // the tube is wider than the hole: beyond the axis
        rho = -rho;
        phi += phi < kTurn / 2 ? kTurn / 2 : -kTurn / 2;
    }
    double theta = std::atan2(p.z, rho - s.major) - s.theta_min;
    theta -= std::floor(theta / kTurn) * kTurn;
    // Rounding may put a point before the first parallel.
    if (theta - s.range > kTurn - theta) theta -= kTurn;
    return {phi, theta / s.range};
}

double SurfaceOfRevolution::v_of(double x, double& density) const {
    double v = x;
    if (const auto* s = std::get_if<Segment>(&profile_)) {
        v = linear_quantile(s->rho[0], s->rho[1], x);
    } else if (const auto* bowl = std::get_if<Bowl>(&profile_)) {
        // Area from the vertex to z goes with (z + k / 4)^(3/2) - (k / 4)^(3/2).
        const double c = bowl->k / 4;
        const double low = std::pow(bowl->z_min + c, 1.5);
        const double high = std::pow(bowl->z_min + bowl->range + c, 1.5);
        v = (std::cbrt(std::pow(low + x * (high - low), 2)) - c - bowl->z_min) / bowl->range;
    }
    v = std::clamp(v, 0.0, 1.0);
    x_of(v, density);
    return v;
}

double SurfaceOfRevolution::x_of(double v, double& density) const {
    density = 1;
    if (const auto* s = std::get_if<Segment>(&profile_)) {
        const double a = s->rho[0], b = s->rho[1];
        density = 2 * (a + (b - a) * v) / (a + b);
        return linear_cdf(a, b, v);
    }
    if (const auto* bowl = std::get_if<Bowl>(&profile_)) {
        const double c = bowl->k / 4;
        const double low = std::pow(bowl->z_min + c, 1.5);
        const double high = std::pow(bowl->z_min + bowl->range + c, 1.5);
        const double base = bowl->z_min + bowl->range * v + c;
        density = 1.5 * std::sqrt(base) * bowl->range / (high - low);
        return (std::pow(base, 1.5) - low) / (high - low);
    }
    return v;
}

}  // namespace lxs
