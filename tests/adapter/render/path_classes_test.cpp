// Protects docs/understand/who-carries-which-light.md: every class of paths is carried by exactly
// one strategy, so that an image made with shadow rays and photons equals one made with photons
// alone.
#include <gtest/gtest.h>

#include "render_mock.h"
#include "scene_with_lights.h"

namespace aips::path_classes_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kSize = 16;

/// Mean luminance of one view, with the given division of labour.
double mean_of(const aips::Scene& scene, const mock::Camera& camera, bool direct, bool glossy,
               GuideKind guide = GuideKind::None, double radius = 2) {
    Settings settings = mock::small_settings(31, 60000);
    settings.direct_light_sampling = direct;
    settings.store_glossy = glossy;
    settings.guide = guide;
    settings.start_radius = radius;
    return mock::render(scene, camera, kSize, kSize, settings, 20).film.mean();
}

/// A floor lit by a quad lamp, `between` lying halfway between them.
mock::Scene floor_under_lamp(const mock::Material& floor, const mock::Material* between) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    ground.material = floor;
    scene.add(ground);
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-0.5f, -0.5f, 2}, {0, 1, 0}, {1, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {5, 5, 5};
    scene.add(lamp);
    if (between) {
        mock::Surface sheet;
        sheet.shape = mock::Quad{{-3, -3, 1.5f}, {6, 0, 0}, {0, 6, 0}};
        sheet.material = *between;
        scene.add(sheet);
    }
    scene.finish();
    return scene;
}

mock::Camera camera_down() {
    return {{0, 0, 1}, {0, 0, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, kSize, kSize};
}

/// Row "L D E".
TEST(PathClasses, DirectLightOnDiffuse) {
    const mock::Scene scene = floor_under_lamp({}, nullptr);
    const double rays = mean_of(scene, camera_down(), true, false);
    const double photons = mean_of(scene, camera_down(), false, false);
    EXPECT_NEAR(photons / rays, 1, 0.01);
}

/// Row "L n D E": a null surface between lamp and floor counts as nothing.
TEST(PathClasses, DirectLightThroughNull) {
    mock::Material null;
    null.kind = Kind::Null;
    const double bare = mean_of(floor_under_lamp({}, nullptr), camera_down(), true, false);
    const mock::Scene scene = floor_under_lamp({}, &null);
    EXPECT_NEAR(mean_of(scene, camera_down(), true, false) / bare, 1, 0.01);
    EXPECT_NEAR(mean_of(scene, camera_down(), false, false) / bare, 1, 0.01);
}

/// Row "L S+ D E": light through real glass comes from photons in both cases.
TEST(PathClasses, LightThroughGlassBelongsToPhotons) {
    mock::Material glass;
    glass.kind = Kind::Glass;
    glass.index = 1.0001f;  // bends nothing, but is no null surface: shadow rays are blocked
    const mock::Scene scene = floor_under_lamp({}, &glass);
    const double bare = mean_of(floor_under_lamp({}, nullptr), camera_down(), true, false);
    EXPECT_NEAR(mean_of(scene, camera_down(), true, false) / bare, 1, 0.01);
    EXPECT_NEAR(mean_of(scene, camera_down(), false, false) / bare, 1, 0.01);
}

/// Row "L G E": a glossy floor mirrors the lamp; bounces weighed against shadow rays, bounces
/// alone, and photons stored on the glossy lobe agree.
TEST(PathClasses, DirectLightOnGlossy) {
    mock::Material phong;
    phong.kind = Kind::Phong;
    phong.exponent = 8;
    const mock::Scene scene = floor_under_lamp(phong, nullptr);
    const mock::Camera camera{{0, -1, 1}, {0, 0.6f, -0.8f}, {0.2f, 0, 0}, {0, 0.16f, 0.12f}, kSize,
                              kSize};
    const double weighed = mean_of(scene, camera, true, false);
    EXPECT_NEAR(mean_of(scene, camera, false, false) / weighed, 1, 0.01);
    EXPECT_NEAR(mean_of(scene, camera, true, true) / weighed, 1, 0.01);
    EXPECT_NEAR(mean_of(scene, camera, false, true) / weighed, 1, 0.01);
}

/// Rows "L E" and "L S+ E": the lamp itself, seen by the eye or in a mirror, comes from eye paths.
TEST(PathClasses, LampSeenDirectlyAndInMirror) {
    mock::Material mirror;
    mirror.kind = Kind::Mirror;
    mirror.reflectance = {0.5f, 0.5f, 0.5f};
    const mock::Scene scene = floor_under_lamp(mirror, nullptr);
    const mock::Camera up{{0, 0, 1}, {0, 0, 1}, {0.2f, 0, 0}, {0, 0.2f, 0}, kSize, kSize};
    const mock::Camera down{{0, 0, 1}, {0, 0, -1}, {0.1f, 0, 0}, {0, 0.1f, 0}, kSize, kSize};
    for (const bool direct : {true, false}) {
        EXPECT_NEAR(mean_of(scene, up, direct, false), 5, 1e-4);
        EXPECT_NEAR(mean_of(scene, down, direct, false), 2.5, 1e-4);
    }
}

class HiddenLight final : public mock::LightLike {
  public:
    using LightLike::LightLike;
    bool hidden_from_camera() const override { return true; }
};

/// Rows "L E" and "L S+ E" of lamps that are hidden from the camera: nobody carries the first,
/// whatever null surface it comes through, and all else is as it was.
TEST(PathClasses, LampHiddenFromTheCamera) {
    mock::Material mirror, null;
    mirror.kind = Kind::Mirror;
    mirror.reflectance = {0.5f, 0.5f, 0.5f};
    null.kind = Kind::Null;
    const mock::Scene scene = floor_under_lamp(mirror, &null), lit = floor_under_lamp({}, nullptr);
    const HiddenLight over_mirror(*scene.lights()[0]), over_floor(*lit.lights()[0]);
    const mock::SceneWithLights hidden(scene, {&over_mirror}), hidden_lit(lit, {&over_floor});
    const mock::Camera up{{0, 0, 1}, {0, 0, 1}, {0.2f, 0, 0}, {0, 0.2f, 0}, kSize, kSize};
    const mock::Camera down{{0, 0, 1}, {0, 0, -1}, {0.1f, 0, 0}, {0, 0.1f, 0}, kSize, kSize};
    for (const bool direct : {true, false}) {
        EXPECT_EQ(mean_of(hidden, up, direct, false), 0);
        EXPECT_NEAR(mean_of(hidden, down, direct, false), 2.5, 1e-4);
        EXPECT_EQ(mean_of(hidden_lit, camera_down(), direct, false),
                  mean_of(lit, camera_down(), direct, false));
    }
    mock::Scene sky = floor_under_lamp({}, nullptr);
    sky.add_environment({2, 2, 2});
    sky.finish();
    const HiddenLight above(*sky.lights()[0]);
    const mock::SceneWithLights hidden_sky(sky, {&above, sky.lights()[1]});
    const mock::Camera aside{{0, 0, 1}, {1, 0, 0.5f}, {0, 0.1f, 0}, {0, 0, 0.1f}, kSize, kSize};
    EXPECT_EQ(mean_of(hidden_sky, aside, true, false), 0);
}

/// Row "environment": seen directly, by shadow rays, and by photons.
TEST(PathClasses, Environment) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    scene.add(ground);
    scene.add_environment({2, 2, 2});
    scene.finish();
    EXPECT_NEAR(mean_of(scene, camera_down(), true, false), 1, 0.03);  // 10240 shadow rays
    EXPECT_NEAR(mean_of(scene, camera_down(), false, false), 1, 0.01);
    const mock::Camera up{{0, 0, 1}, {0, 0, 1}, {0.2f, 0, 0}, {0, 0.2f, 0}, kSize, kSize};
    EXPECT_NEAR(mean_of(scene, up, true, false), 2, 1e-5);
}

/// A sky that is hidden from camera and mirrors still lights gloss, by whatever strategy.
TEST(PathClasses, HiddenEnvironmentOnGlossy) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    ground.material.kind = Kind::Phong;
    ground.material.exponent = 8;
    scene.add(ground);
    scene.add_environment({2, 2, 2});
    scene.finish();
    Settings settings = mock::small_settings(31, 1000);
    settings.include_environment = false;
    const auto mean = [&](bool direct) {
        settings.direct_light_sampling = direct;
        return mock::render(scene, camera_down(), kSize, kSize, settings, 20).film.mean();
    };
    EXPECT_NEAR(mean(false) / mean(true), 1, 0.03);
}

/// Row "delta lights": a point light is never met by eye paths and counted once.
TEST(PathClasses, PointLight) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    scene.add(ground);
    scene.add_point_light({0, 0, 1.5f}, {3, 3, 3});
    scene.finish();
    const double rays = mean_of(scene, camera_down(), true, false);
    EXPECT_NEAR(mean_of(scene, camera_down(), false, false) / rays, 1, 0.01);
}

/// Rows "L D+ D E" with mixed lobes: both divisions of labour, guided or not, agree in a box.
TEST(PathClasses, IndirectLightInABox) {
    mock::Material ball;
    ball.kind = Kind::LambertAndMirror;
    ball.specular = {0.4f, 0.4f, 0.4f};
    const mock::Scene scene = mock::lamp_box({}, ball);
    const mock::Camera camera = mock::camera_along_y({0, -0.95f, 0}, 1, kSize, kSize);
    // The whole box is in view: a small radius keeps the darkening at its edges below the
    // tolerance.
    constexpr double kRadius = 0.25;
    const double reference = mean_of(scene, camera, true, false, GuideKind::None, kRadius);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper}) {
        EXPECT_NEAR(mean_of(scene, camera, false, false, guide, kRadius) / reference, 1, 0.015);
    }
    EXPECT_NEAR(mean_of(scene, camera, true, false, GuideKind::Paper, kRadius) / reference, 1,
                0.015);
}

/// Light groups: what each lamp brings adds up to the whole.
TEST(PathClasses, LightGroupsAddUp) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    scene.add(ground);
    for (std::uint32_t g = 0; g < 2; ++g) {
        mock::Surface lamp;
        lamp.shape = mock::Quad{{-1.0f + float(g), -0.5f, 2}, {0, 1, 0}, {1, 0, 0}};
        lamp.emitted = Rgb{1, 1, 1} * float(g + 1);
        lamp.light_group = g;
        scene.add(lamp);
    }
    scene.set_light_groups(2);
    scene.finish();
    Settings settings = mock::small_settings(33, 40000);
    const auto r = mock::render(scene, camera_down(), kSize, kSize, settings, 20);
    const double first = mock::mean_luminance(r.film.image_of_group(0), kSize, 0, 0, kSize, kSize);
    const double second = mock::mean_luminance(r.film.image_of_group(1), kSize, 0, 0, kSize, kSize);
    EXPECT_NEAR((first + second) / r.film.mean(), 1, 1e-5);
    EXPECT_NEAR(second / first, 2, 0.05);
}

}  // namespace
}  // namespace aips::path_classes_test
