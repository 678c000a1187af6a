// Built by medians, met in double precision.
#include "triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace aips {
namespace {

constexpr std::uint32_t kLeafTriangles = 4;
/// Medians halve: 2^32 triangles would have less depth.
constexpr int kMostDepth = 40;

struct Vec3d {
    double x, y, z;
};
Vec3d between(Vec3 a, Vec3 b) {
    return {double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z};
}
double dot(Vec3d a, Vec3d b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Distance at which a ray meets a triangle (Moeller & Trumbore 1997), negative if it does not.
double meet(const Triangle& t, Vec3 origin, Vec3 direction) {
    const Vec3d u = between(t.a, t.b), v = between(t.a, t.c), o = between(t.a, origin);
    const Vec3d d{direction.x, direction.y, direction.z};
    const Vec3d p = cross(d, v), q = cross(o, u);
    const double det = dot(u, p);
    if (det == 0) return -1;
    const double a = dot(o, p) / det, b = dot(d, q) / det;
    return a >= 0 && b >= 0 && a + b <= 1 ? dot(v, q) / det : -1;
}

/// Whether a ray meets a box before `farthest`.
bool meets(const Bounds& box, Vec3 origin, Vec3 inverse, double farthest) {
    double t0 = 0, t1 = farthest;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isinf(inverse[axis])) {
            // Along the faces: 0 * infinity would not tell a ray within one from those outside.
            if (origin[axis] < box.lower[axis] || origin[axis] > box.upper[axis]) return false;
            continue;
        }
        const double a = (double(box.lower[axis]) - origin[axis]) * inverse[axis];
        const double b = (double(box.upper[axis]) - origin[axis]) * inverse[axis];
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
    // Rounding of the inverse must not cut a triangle off.
    return t0 <= t1 * (1 + 1e-6);
}

Bounds bounds_of(const Triangle& t) {
    Bounds bounds;
    for (const Vec3 p : {t.a, t.b, t.c})
        bounds.extend(p);
    return bounds;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles)
    : triangles_(triangles), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, std::uint32_t(order_.size()));
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
    const std::size_t number = nodes_.size();
    nodes_.push_back({{}, first, count});
    Bounds bounds, centers;
    for (std::uint32_t i = first; i < first + count; ++i) {
        bounds.extend(bounds_of(triangles_[order_[i]]));
        centers.extend(bounds_of(triangles_[order_[i]]).center());
    }
    nodes_[number].bounds = bounds;
    if (count <= kLeafTriangles) return;
    const int axis = centers.longest_axis();
    const auto begin = order_.begin() + first;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const float x = bounds_of(triangles_[a]).center()[axis];
        const float y = bounds_of(triangles_[b]).center()[axis];
        return x < y || (x == y && a < b);
    });
    nodes_[number].count = 0;
    build(first, half);
    nodes_[number].first = std::uint32_t(nodes_.size());
    build(first + half, count - half);
}

bool TriangleTree::nearest(Vec3 origin, Vec3 direction, double farthest, Hit& hit) const {
    if (nodes_.empty()) return false;
    const Vec3 inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
    std::array<std::uint32_t, kMostDepth> waiting{};
    int count = 0;
    waiting[std::size_t(count++)] = 0;
    bool found = false;
    while (count > 0) {
        const std::uint32_t number = waiting[std::size_t(--count)];
        const Node& node = nodes_[number];
        if (!meets(node.bounds, origin, inverse, farthest)) continue;
        if (node.count == 0) {
            waiting[std::size_t(count++)] = node.first;
            waiting[std::size_t(count++)] = number + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const double t = meet(triangles_[order_[i]], origin, direction);
            const bool nearer =
                t < farthest || (found && t == farthest && order_[i] < hit.triangle);
            if (!(t > 0) || !nearer) continue;
            farthest = t;
            hit = {t, order_[i]};
            found = true;
        }
    }
    return found;
}

}  // namespace aips
