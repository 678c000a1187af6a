// Curves as meshes of tubes.
#include "curve_tubes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lxs::pbrt {
namespace {

/// How finely a curve becomes a tube with smooth normals. Hair is thinner than a pixel, and there
/// is much of it; of what is thicker than a fiftieth of its length the shape is seen.
struct Fineness {
    std::size_t steps, sides;
};
constexpr double kThick = 0.02;

const Imath::V3d kX(1, 0, 0), kY(0, 1, 0);

Fineness fineness_of(const Curve& curve) {
    double length = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const auto &a = curve.points[i - 1], &b = curve.points[i];
        length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
    if (std::max(curve.width0, curve.width1) > kThick * length) return {16, 16};
    return {curve.segments() > 3 ? 2u : 4u, 3};
}

using Point = std::array<double, 3>;

/// Point of a Bezier curve by de Casteljau's construction.
Imath::V3d on_bezier(const Point* points, std::size_t degree, double t) {
    std::array<Imath::V3d, 4> p;
    for (std::size_t i = 0; i <= degree; ++i)
        p[i] = {points[i][0], points[i][1], points[i][2]};
    for (std::size_t n = degree; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i)
            p[i] += (p[i + 1] - p[i]) * t;
    return p[0];
}

/// Point of a uniform B-spline by its basis functions.
Imath::V3d on_spline(const Point* points, std::size_t degree, double t) {
    const double s = 1 - t, t2 = t * t, t3 = t2 * t;
    const std::array<double, 4> w =
        degree == 2 ? std::array<double, 4>{s * s / 2, 0.5 + t - t2, t2 / 2, 0}
                    : std::array<double, 4>{s * s * s / 6, (3 * t3 - 6 * t2 + 4) / 6,
                                            (-3 * t3 + 3 * t2 + 3 * t + 1) / 6, t3 / 6};
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i <= degree; ++i)
        sum += Imath::V3d(points[i][0], points[i][1], points[i][2]) * w[i];
    return sum;
}

}  // namespace

std::size_t Curve::segments() const {
    const auto n = static_cast<std::size_t>(degree);
    if (points.size() <= n) return 0;
    if (spline) return points.size() - n;
    return (points.size() - 1) % n == 0 ? (points.size() - 1) / n : 0;
}

void CurveTubes::add_ring(const Imath::V3d& centre, const Imath::V3d& along, const Imath::V3d& side,
                          double radius, std::size_t sides, double v) {
    // A polygon of the circle's perimeter has its width, in the mean over directions.
    const double part = std::numbers::pi / static_cast<double>(sides);
    radius *= part / std::sin(part);
    const Imath::V3d up = side % along;
    for (std::size_t k = 0; k < sides; ++k) {
        const double u = static_cast<double>(k) / static_cast<double>(sides),
                     angle = 2 * std::numbers::pi * u;
        const Imath::V3d out = side * std::cos(angle) + up * std::sin(angle);
        const Imath::V3d at = centre + out * radius;
        points_.insert(points_.end(), {at.x, at.y, at.z});
        normals_.insert(normals_.end(), {out.x, out.y, out.z});
        uv_.insert(uv_.end(), {u, v});
    }
}

void CurveTubes::add(const Curve& curve) {
    const std::size_t segments = curve.segments();
    const auto [steps, sides] = fineness_of(curve);
    const auto degree = static_cast<std::size_t>(curve.degree);
    const auto on_curve = curve.spline ? on_spline : on_bezier;
    std::vector<Imath::V3d> places;
    for (std::size_t s = 0; s < segments; ++s) {
        const Point* const first = &curve.points[curve.spline ? s : s * degree];
        for (std::size_t k = s == 0 ? 0 : 1; k <= steps; ++k)
            places.push_back(on_curve(first, degree, static_cast<double>(k) / double(steps)));
    }
    Imath::V3d side(0.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        Imath::V3d along = places[std::min(i + 1, places.size() - 1)] - places[i == 0 ? 0 : i - 1];
        along = along.length() > 0 ? along.normalized() : Imath::V3d(0, 0, 1);
        // Carried on from ring to ring, so that the tube does not twist.
        side -= along * (side ^ along);
        if (!(side.length() > 1e-6)) side = along % (std::abs(along.x) < 0.7 ? kX : kY);
        side.normalize();
        const double v = static_cast<double>(i) / static_cast<double>(places.size() - 1);
        const std::size_t ring = points_.size() / 3;
        add_ring(places[i], along, side, (curve.width0 + (curve.width1 - curve.width0) * v) / 2,
                 sides, v);
        if (i + 1 == places.size()) continue;
        for (std::size_t k = 0; k < sides; ++k) {
            const auto a = static_cast<double>(ring + k);
            const auto b = static_cast<double>(ring + (k + 1) % sides);
            const auto next = static_cast<double>(sides);
            triangles_.insert(triangles_.end(), {a, b, b + next, a, b + next, a + next});
        }
    }
}

void CurveTubes::move_to(NewStatement& mesh) {
    mesh.name("trianglemesh")
        .set("integer triindices", std::exchange(triangles_, {}))
        .set("point P", std::exchange(points_, {}))
        .set("normal N", std::exchange(normals_, {}))
        .set("float uv", std::exchange(uv_, {}))
        .set("bool facesbynormals", "true");
}

}  // namespace lxs::pbrt
