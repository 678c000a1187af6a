// The sphere around a scene.
#include "scene_sphere.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

SceneSphere enclosing_sphere(const Bounds& box) {
    if (box.isEmpty()) return {};
    constexpr float kRoundingMargin = 1.00001f;
    const float radius = (box.max - box.min).length() / 2 * kRoundingMargin;
    return {box.center(), radius > 0 ? radius : 1.0f, Bounds()};
}

}  // namespace

std::vector<Vec3> camera_places(const SceneContents& contents) {
    const auto camera = contents.options.find("Camera");
    if (camera == contents.options.end()) return {};
    const auto place = [](const Matrix& to_camera) {
        return Vec3(Imath::V3d(to_camera.inverse().translation()));
    };
    std::vector<Vec3> places = {place(camera->second.transform)};
    for (const MotionKey& key : camera->second.motion)
        places.push_back(place(key.matrix));
    return places;
}

SceneSphere unbounded_media_end(const SceneContents& contents, const Bounds& bounds) {
    Bounds box = bounds;
    if (contents.camera_medium) {
        for (const Vec3& place : camera_places(contents))
            box.extendBy(place);
    }
    SceneSphere sphere = enclosing_sphere(box);
    sphere.surfaces = bounds;
    return sphere;
}

float distance_to_end(const SceneSphere& sphere, const Ray& ray) {
    const Vec3 to_center = sphere.center - ray.origin;
    const float approach = to_center.dot(ray.direction);
    const float beside = (to_center - ray.direction * approach).length2();
    const float half_chord = std::sqrt(std::max(0.0f, sphere.radius * sphere.radius - beside));
    return std::max(approach + half_chord, 0.0f);
}

}  // namespace lxs
