// Reconstruction of surface points with error bounds after Pharr, Jakob and Humphreys 2016,
// "Physically Based Rendering", 3rd edition, section 3.9, extended by the kernel's own error.
//
// The position itself is computed in double precision, so that its error is its final rounding.
// What remains is the error with which the kernel sees the surface when a ray leaves this point.
#include "surface_point.h"

#include <algorithm>
#include <cmath>

#include "triangle_weights.h"

namespace lxs {
namespace {

using Imath::V3d;

/// Rounds `p` into the hit. `error` adds to every coordinate's bound. Twice the unit roundoff: p's
/// own rounding, and that of moving an origin by the bound.
void set_position(const V3d& p, double error, SurfaceHit& hit) {
    hit.p = Vec3(p);
    const auto all = static_cast<float>(error);
    hit.p_error = Vec3(std::abs(hit.p.x), std::abs(hit.p.y), std::abs(hit.p.z)) * 0x1p-23f +
                  Vec3(all, all, all);
}

/// Tangent along u from the texture coordinates of the corners; zero where they don't give one.
Vec3 tangent(const Vec2& uv0, const Vec2& uv1, const Vec2& uv2, const V3d& e1, const V3d& e2) {
    const V3d d1(uv1.x - uv0.x, uv1.y - uv0.y, 0), d2(uv2.x - uv0.x, uv2.y - uv0.y, 0);
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    if (!(std::abs(determinant) > 1e-30)) return Vec3(0.0f);
    return Vec3((e1 * d2.y - e2 * d1.y) * (1 / determinant));
}

Vec3 normalized_or(const Vec3& v, const Vec3& fallback) {
    const float length2 = v.dot(v);
    return length2 > 1e-20f ? v / std::sqrt(length2) : fallback;
}

struct ShapeRay {
    V3d origin, direction;
};

ShapeRay ray_in_shape(const InstanceTransform* instance, const Ray& ray) {
    const V3d origin(ray.origin), direction(ray.direction);
    if (!instance) return {origin, direction};
    return {instance->map().inverse_point(origin), instance->map().inverse_vector(direction)};
}

void locate_on_triangle(const Surface& surface, const InstanceTransform* instance, const Ray& ray,
                        RawHit& raw, SurfaceHit& hit) {
    const std::uint32_t* corner = surface.indices + 3 * static_cast<std::size_t>(raw.primitive);
    const std::uint32_t i0 = corner[0], i1 = corner[1], i2 = corner[2];
    const V3d p0(surface.positions[i0]);
    const V3d e1 = V3d(surface.positions[i1]) - p0, e2 = V3d(surface.positions[i2]) - p0;
    const TrianglePlane plane = surface.planes.empty() ? triangle_plane(e1, e2, surface.reversed)
                                                       : surface.planes[raw.primitive];
    const auto [origin, direction] = ray_in_shape(instance, ray);
    refine_weights({p0, e1, e2}, origin, direction, raw);
    const V3d p = p0 + e1 * raw.u + e2 * raw.v;
    const auto u = static_cast<float>(raw.u), v = static_cast<float>(raw.v);

    Vec3 shading(0.0f);
    if (surface.normals) {
        shading =
            surface.normals[i0] * (1 - u - v) + surface.normals[i1] * u + surface.normals[i2] * v;
    }
    hit.uv = Vec2(0.5f, 0.5f);  // as LuxRender where a mesh has no coordinates
    hit.dpdu = Vec3(0.0f);
    if (surface.uvs && surface.reads_uv) {
        const Vec2 &uv0 = surface.uvs[i0], &uv1 = surface.uvs[i1], &uv2 = surface.uvs[i2];
        hit.uv = uv0 * (1 - u - v) + uv1 * u + uv2 * v;
        hit.dpdu = tangent(uv0, uv1, uv2, e1, e2);
    }
    if (instance) {
        const AffineMap& map = instance->map();
        V3d normal = map.normal(V3d(plane.normal));
        // A distance along the object's normal, times the ratio of world to object heights.
        const double height_ratio = 1 / std::sqrt(normal.dot(normal));
        hit.ng = Vec3(normal * height_ratio);
        set_position(map.point(p), static_cast<double>(plane.error) * height_ratio, hit);
        hit.p_error += instance->tracing_error(hit.p);
        if (surface.normals) shading = Vec3(map.normal(V3d(shading)));
        if (surface.uvs) hit.dpdu = Vec3(map.vector(V3d(hit.dpdu)));
    } else {
        hit.ng = plane.normal;
        set_position(p, static_cast<double>(plane.error), hit);
    }
    if (!surface.normals) {
        hit.ns = hit.ng;
        return;
    }
    shading = normalized_or(shading, hit.ng);
    hit.ns = shading.dot(hit.ng) < 0 ? -shading : shading;
}

void locate_on_quadric(const Surface& surface, const InstanceTransform* instance, const Ray& ray,
                       const RawHit& raw, SurfaceHit& hit) {
    const auto [origin, direction] = ray_in_shape(instance, ray);
    const auto parts = surface.reads_uv ? QuadricShape::Parts::All : QuadricShape::Parts::Place;
    QuadricPoint point = surface.quadric->point(origin, direction, raw.distance, parts);
    double error = surface.quadric->rounding();
    if (instance) {
        point.p = instance->map().point(point.p);
        const V3d image = instance->map().normal(point.normal);
        error /= image.length();
        point.normal = image.normalized();
        point.dpdu = instance->map().vector(point.dpdu);
    }
    set_position(point.p, error, hit);
    if (instance) hit.p_error += instance->tracing_error(hit.p);
    hit.ng = Vec3(surface.reversed ? -point.normal : point.normal);
    hit.ns = hit.ng;
    hit.uv = point.uv;
    hit.dpdu = Vec3(point.dpdu);
}

/// A quadric's tangent along v at the surface point nearest to the hit.
Vec3 quadric_tangent_along_v(const QuadricShape& quadric, const InstanceTransform* instance,
                             const SurfaceHit& hit) {
    const V3d p = instance ? instance->map().inverse_point(V3d(hit.p)) : V3d(hit.p);
    const V3d dpdv = quadric.point(p, V3d(0.0), 0).dpdv;
    return Vec3(instance ? instance->map().vector(dpdv) : dpdv);
}

template <class T>
T at_corners(const T* values, const std::uint32_t* corner, const RawHit& raw) {
    const auto u = static_cast<float>(raw.u), v = static_cast<float>(raw.v);
    return values[corner[0]] * (1 - u - v) + values[corner[1]] * u + values[corner[2]] * v;
}

}  // namespace

void add_vertex_values(const Surface& surface, const RawHit& raw, TexturePoint& point) {
    if (!surface.colors && !surface.alphas) return;
    const std::uint32_t* corner = surface.indices + 3 * static_cast<std::size_t>(raw.primitive);
    if (surface.colors) point.color = at_corners(surface.colors, corner, raw);
    if (surface.alphas) point.alpha = at_corners(surface.alphas, corner, raw);
}

void locate(const Surface& surface, const InstanceTransform* instance, const Ray& ray, RawHit& raw,
            SurfaceHit& hit) {
    hit.distance = raw.distance;
    if (surface.positions) {
        locate_on_triangle(surface, instance, ray, raw, hit);
    } else {
        locate_on_quadric(surface, instance, ray, raw, hit);
    }
}

Vec3 tangent_along_v(const Surface& surface, const InstanceTransform* instance, const RawHit& raw,
                     const SurfaceHit& hit) {
    if (!surface.positions) return quadric_tangent_along_v(*surface.quadric, instance, hit);
    if (!surface.uvs) return Vec3(0.0f);
    const std::uint32_t* corner = surface.indices + 3 * static_cast<std::size_t>(raw.primitive);
    const V3d p0(surface.positions[corner[0]]);
    const V3d e1 = V3d(surface.positions[corner[1]]) - p0;
    const V3d e2 = V3d(surface.positions[corner[2]]) - p0;
    const auto vu = [&](int i) {
        const Vec2& uv = surface.uvs[corner[i]];
        return Vec2(uv.y, uv.x);
    };
    const Vec3 dpdv = tangent(vu(0), vu(1), vu(2), e1, e2);
    return instance ? Vec3(instance->map().vector(V3d(dpdv))) : dpdv;
}

}  // namespace lxs
