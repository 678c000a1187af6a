// Rays against quads and balls, one after the other.
#include "mock_shapes.h"

#include <cmath>

namespace mock {

using aips::Vec3;

Vec3 front_normal(const Shape& shape, Vec3 position) {
    if (const Quad* quad = std::get_if<Quad>(&shape)) {
        return normalize(cross(quad->edge_u, quad->edge_v));
    }
    const Ball& ball = std::get<Ball>(shape);
    const Vec3 n = normalize(position - ball.center);
    return ball.inside_out ? -n : n;
}

void extend(aips::Bounds& bounds, const Shape& shape) {
    if (const Quad* q = std::get_if<Quad>(&shape)) {
        for (const Vec3 p : {q->corner, q->corner + q->edge_u, q->corner + q->edge_v,
                             q->corner + q->edge_u + q->edge_v}) {
            bounds.extend(p);
        }
        return;
    }
    const Ball& ball = std::get<Ball>(shape);
    const Vec3 r{ball.radius, ball.radius, ball.radius};
    bounds.extend(ball.center - r);
    bounds.extend(ball.center + r);
}

RayTargets::Vec3d RayTargets::cross_over(Vec3d a, Vec3d b, double divisor) {
    return {(a.y * b.z - a.z * b.y) / divisor, (a.z * b.x - a.x * b.z) / divisor,
            (a.x * b.y - a.y * b.x) / divisor};
}

void RayTargets::add(const Shape& shape) {
    Target target;
    if (const Quad* quad = std::get_if<Quad>(&shape)) {
        const Vec3d u = wide(quad->edge_u), v = wide(quad->edge_v);
        target.origin = wide(quad->corner);
        target.normal = cross_over(u, v, 1);
        const double squared = dot(target.normal, target.normal);
        target.to_s = cross_over(v, target.normal, squared);
        target.to_t = cross_over(target.normal, u, squared);
    } else {
        const Ball& ball = std::get<Ball>(shape);
        target.ball = true;
        target.origin = wide(ball.center);
        target.radius = ball.radius;
    }
    targets_.push_back(target);
}

/// Nearest distance in (t_min, t_max), or a negative number.
inline double RayTargets::quad_distance(const Target& quad, const Vec3d& o, const Vec3d& d,
                                        double t_min, double t_max) {
    const double along = dot(quad.normal, d);
    if (along == 0) return -1;
    const double t = dot(quad.normal, quad.origin - o) / along;
    if (!(t > t_min && t < t_max)) return -1;
    const Vec3d p{o.x + d.x * t - quad.origin.x, o.y + d.y * t - quad.origin.y,
                  o.z + d.z * t - quad.origin.z};
    const double a = dot(quad.to_s, p), b = dot(quad.to_t, p);
    return a >= 0 && a <= 1 && b >= 0 && b <= 1 ? t : -1;
}

/// Nearest distance in (t_min, t_max), or a negative number.
inline double RayTargets::ball_distance(const Target& ball, const Vec3d& o, const Vec3d& d,
                                        double t_min, double t_max) {
    const Vec3d oc = o - ball.origin;
    const double b = dot(oc, d), c = dot(oc, oc) - ball.radius * ball.radius;
    const double disc = b * b - c;
    if (disc < 0) return -1;
    const double root = std::sqrt(disc);
    // A ray that starts on the ball, up to the rounding of its origin, meets it at the chord's
    // other end alone: else one in 10^5 entered from outside what it was to cross within.
    const double rounding = 4 * 0x1p-23 * (std::sqrt(dot(o, o)) + ball.radius);
    const bool starts_on_ball = std::abs(c) < 2 * ball.radius * rounding;
    for (const double t : {-b - root, -b + root}) {
        if (t > t_min && t < t_max && !(starts_on_ball && std::abs(t) < std::abs(b))) return t;
    }
    return -1;
}

bool RayTargets::nearest(const aips::Ray& ray, double t_min, double t_max, Hit& hit) const {
    const Vec3d o = wide(ray.origin), d = wide(ray.direction);
    bool found = false;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const Target& target = targets_[i];
        const double t = target.ball ? ball_distance(target, o, d, t_min, t_max)
                                     : quad_distance(target, o, d, t_min, t_max);
        if (t > 0) {
            t_max = t;
            hit = {t, i};
            found = true;
        }
    }
    return found;
}

}  // namespace mock
