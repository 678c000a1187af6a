// A dark room with a small bright lamp, a mirror ball and a glass ball: images of the lamp far
// smaller than pixels.
#pragma once

#include "render_mock.h"

namespace mock {

/// Seen from its front; the lamp itself, a ball, is above the camera. `groups`: it has the last.
inline View lamp_room(std::uint32_t size, float lamp_radius = 0.05f, std::uint32_t groups = 1) {
    Material wall, black, mirror, glass;
    wall.reflectance = {0.02f, 0.02f, 0.02f};
    black.reflectance = {0, 0, 0};
    mirror.kind = Material::Kind::Mirror;
    mirror.reflectance = {0.9f, 0.8f, 0.7f};
    glass.kind = Material::Kind::Glass;
    glass.reflectance = {1, 1, 1};
    View view{{}, camera_along_y({0, -0.9f, 0}, 0.6f, size, size)};
    Scene& scene = view.scene;
    scene.set_light_groups(groups);
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {Quad{}, wall});
    scene.add({Ball{{-0.35f, 0.3f, -0.1f}, 0.3f}, mirror});
    scene.add({Ball{{0.35f, 0.2f, 0.1f}, 0.3f}, glass});
    scene.add({Ball{{0.3f, -0.75f, 0.7f}, lamp_radius}, black, {90, 80, 70}, {}, groups - 1});
    scene.finish();
    return view;
}

}  // namespace mock
