// Builds the room with every length at its scale.
#include "placed_room.h"

namespace stress {

using namespace aips;

mock::View placed_room(const RoomPlace& place, std::uint32_t size) {
    const float s = place.scale;
    const auto at = [&](float x, float y, float z) { return place.middle + Vec3{x, y, z} * s; };
    mock::Scene scene;
    mock::Surface wall;
    wall.material.reflectance = {0.7f, 0.6f, 0.5f};
    scene.add_box(at(-1, -1, -1), at(1, 1, 1), wall);
    mock::Surface glass;
    glass.shape = mock::Ball{at(-0.4f, 0.2f, -0.5f), 0.3f * s, false};
    glass.material.kind = mock::Material::Kind::Glass;
    glass.material.reflectance = kWhite;
    scene.add(glass);
    mock::Surface shiny;
    shiny.shape = mock::Ball{at(0.4f, 0.4f, -0.6f), 0.35f * s, false};
    shiny.material = mock::half_mirror();
    scene.add(shiny);
    mock::Surface lamp;
    lamp.shape = mock::Quad{at(-0.3f, -0.3f, 0.9f), {0, 0.6f * s, 0}, {0.6f * s, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = Rgb{10, 9, 8} * place.strength;
    scene.add(lamp);
    scene.add_point_light(at(0.5f, -0.2f, 0.4f), Rgb{1, 1, 2} * (place.strength * s * s));
    scene.finish();
    return {std::move(scene), mock::camera_along_y(at(0, -0.95f, 0), 1, size, size)};
}

}  // namespace stress
