// Roots of quadratic and quartic equations along a ray.
#include "revolution_roots.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lxs {
namespace {

using Imath::V3d;

/// The point of [low, high] where the continuous `f`, of other signs at the ends, is zero: Newton's
/// steps where they stay inside the bracket, else its middle.
template <class F, class Slope>
double bracketed_root(const F& f, const Slope& slope, double low, double high) {
    const bool rising = f(low) < 0;
    double x = (low + high) / 2;
    constexpr int kMostSteps = 80;
    for (int i = 0; i < kMostSteps; ++i) {
        const double value = f(x);
        if (value == 0) return x;
        ((value < 0) == rising ? low : high) = x;
        const double step = value / slope(x);
        double next = x - step;
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (next == x || !(next > low && next < high)) break;
        x = next;
    }
    return x;
}

/// Depressed quartic s^4 + p s^2 + q s + r.
struct Quartic {
    double p, q, r;
    double value(double s) const { return ((s * s + p) * s + q) * s + r; }
    double slope(double s) const { return (4 * s * s + 2 * p) * s + q; }
    double curvature(double s) const { return 12 * s * s + 2 * p; }
};

/// Ascending positions in [-reach, reach] between which `f` may change its sign once, given those
/// between which its derivative's sign can't; the ends are among them.
template <class F, class Slope>
int sign_changes(const F& f, const Slope& slope, const double* at, int count, double* found) {
    int roots = 0;
    for (int i = 0; i + 1 < count; ++i) {
        const double low = f(at[i]), high = f(at[i + 1]);
        if ((low < 0) != (high < 0)) found[roots++] = bracketed_root(f, slope, at[i], at[i + 1]);
    }
    return roots;
}

/// Roots in [-reach, reach], ascending: between extrema, which lie between points of inflection, a
/// polynomial is monotone, so that every change of sign is found and each root's error is that of
/// evaluating the polynomial. Double roots, where a ray grazes, may go unfound.
int quartic_roots(const Quartic& f, double reach, double* roots) {
    const auto value = [&](double s) { return f.value(s); };
    const auto slope = [&](double s) { return f.slope(s); };
    const auto curvature = [&](double s) { return f.curvature(s); };
    double bends[4] = {-reach};
    int bend_count = 1;
    if (f.p < 0) {
        const double bend = std::sqrt(-f.p / 6);
        if (bend < reach) {
            bends[bend_count++] = -bend;
            bends[bend_count++] = bend;
        }
    }
    bends[bend_count++] = reach;
    double turns[5] = {-reach};
    const int turn_count = 1 + sign_changes(slope, curvature, bends, bend_count, turns + 1);
    turns[turn_count] = reach;
    return sign_changes(value, slope, turns, turn_count + 1, roots);
}

}  // namespace

RevolutionRoots::RevolutionRoots(const Quadric& quadric) {
    const SurfaceOfRevolution surface = SurfaceOfRevolution::of(quadric).value();
    middle_ = (surface.z_min() + surface.z_max()) / 2;
    if (const auto* segment = std::get_if<RevolvedSegment>(&quadric.shape)) {
        const V3d start(segment->start), along = V3d(segment->end) - start;
        // The segment's point at z = middle is (x, y) = base + slope * (z - middle).
        const double v = (middle_ - start.z) / along.z;
        const Imath::V2d base(start.x + along.x * v, start.y + along.y * v);
        const Imath::V2d slope(along.x / along.z, along.y / along.z);
        shape_ = Profile{base.dot(base), base.dot(slope), slope.dot(slope)};
    } else if (const auto* bowl = std::get_if<Paraboloid>(&quadric.shape)) {
        const double k = double(bowl->radius) * bowl->radius / bowl->height;
        shape_ = Profile{k * middle_, k / 2, 0};
    } else {
        const Torus& torus = std::get<Torus>(quadric.shape);
        shape_ = Tube{torus.major_radius, torus.minor_radius};
    }
}

RayRoots RevolutionRoots::along(const V3d& origin, const V3d& direction) const {
    const double speed2 = direction.dot(direction);
    if (!(speed2 > 0)) return {};
    const V3d from(origin.x, origin.y, origin.z - middle_);
    const double shift = -from.dot(direction) / speed2;
    const V3d nearest = from + direction * shift;
    const double speed = std::sqrt(speed2);
    RayRoots roots = std::visit(
        [&](const auto& s) { return along(s, nearest, direction * (1 / speed)); }, shape_);
    for (int i = 0; i < roots.count; ++i)
        roots.t[i] = shift + roots.t[i] / speed;
    return roots;
}

RayRoots RevolutionRoots::along(const Profile& s, const V3d& o, const V3d& d) {
    const double a = d.x * d.x + d.y * d.y - s.c2 * d.z * d.z;
    const double b = -(o.x * d.x + o.y * d.y - (s.c1 + s.c2 * o.z) * d.z);  // half, negated
    const double c = o.x * o.x + o.y * o.y - s.c0 - (2 * s.c1 + s.c2 * o.z) * o.z;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return {};
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    if (q == 0) return {};
    const double t0 = c / q, t1 = q / a;
    if (!std::isfinite(t1)) return {{t0}, 1};  // along a generator or the paraboloid's axis
    return {{std::min(t0, t1), std::max(t0, t1)}, 2};
}

// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), and |p|^2 = |o|^2 + s^2 as o is nearest to the centre.
RayRoots RevolutionRoots::along(const Tube& s, const V3d& o, const V3d& d) {
    const double reach2 = (s.major + s.minor) * (s.major + s.minor) - o.dot(o);
    if (!(reach2 > 0)) return {};
    const double g = o.dot(o) + (s.major - s.minor) * (s.major + s.minor);
    const double r4 = 4 * s.major * s.major;
    const Quartic f{2 * g - r4 * (d.x * d.x + d.y * d.y), -2 * r4 * (o.x * d.x + o.y * d.y),
                    g * g - r4 * (o.x * o.x + o.y * o.y)};
    constexpr double kMargin = 1 + 1e-9;  // a root on the enclosing sphere is found
    RayRoots roots;
    roots.count = quartic_roots(f, std::sqrt(reach2) * kMargin, roots.t);
    return roots;
}

}  // namespace lxs
