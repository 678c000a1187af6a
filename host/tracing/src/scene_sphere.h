// The sphere around a scene, where lights at infinity start and endless media end.
#pragma once

#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"

namespace lxs {

/// Where the scene's Camera statement and its motion put the camera; empty without a statement.
std::vector<Vec3> camera_places(const SceneContents& contents);

/// Around all surfaces within `bounds`; if the camera stands in a medium, around the camera too, as
/// in LuxRender.
SceneSphere unbounded_media_end(const SceneContents& contents, const Bounds& bounds);

/// Distance at which a ray that meets no surface leaves the sphere; from outside of it and past it,
/// that of its nearest point to the centre; >= 0.
float distance_to_end(const SceneSphere& sphere, const Ray& ray);

}  // namespace lxs
