// Scenes of a few primitives with materials that do as little as possible.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lxs/scene/contents.h"
#include "lxs/sdk/scene.h"
#include "lxs/tracing/trace_scene.h"
#include "test_geometry.h"

namespace lxs::test {

/// Says it is diffuse; its Bsdf scatters nothing.
std::shared_ptr<const Material> matte();
/// Passes `share` of the light straight on, scatters nothing.
std::shared_ptr<const Material> straight(const Rgb& share);

TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c);
Quadric sphere(float radius, const Matrix& to_world);
Quadric disk(float radius, const Matrix& to_world);

Primitive primitive(Geometry geometry, std::shared_ptr<const Material> material = matte());
AreaEmission emission(const Rgb& radiance);

/// About `axis` by `angle` radians.
Matrix rotation(const Imath::V3d& axis, double angle);

/// `contents` with at least the default group, traced. Warnings are dropped.
std::unique_ptr<TraceScene> trace(SceneContents contents);
std::unique_ptr<TraceScene> trace(std::vector<Primitive> primitives);
/// The same within a medium that no surface bounds, TraceScene::camera_media().
std::unique_ptr<TraceScene> trace_within(std::vector<Primitive> primitives,
                                         std::shared_ptr<const Medium> medium);
/// One object made of `primitives` and an instance of it per transform.
SceneContents instanced(std::vector<Primitive> primitives, const std::vector<Matrix>& transforms);

Ray ray(const Vec3& origin, const Vec3& direction);
/// Scene::intersect with memory of its own; the Bsdf is not to be used.
bool hit(const Scene& scene, const Ray& ray, SurfaceHit& result);

}  // namespace lxs::test
