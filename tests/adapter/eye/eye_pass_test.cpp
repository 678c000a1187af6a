// Protects the eye pass: where visible points arise, and what footprint they carry.
#include <gtest/gtest.h>

#include "render_mock.h"
#include "traced_eye_image.h"

namespace aips::eye_pass_test {
namespace {

using mock::traced_eye_image;

mock::Scene floor_of(const mock::Material& material) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    ground.material = material;
    scene.add(ground);
    mock::Surface ceiling;
    ceiling.shape = mock::Quad{{-2, -2, 3}, {0, 4, 0}, {4, 0, 0}};
    scene.add(ceiling);
    scene.finish();
    return scene;
}

const mock::Camera kDown{{0, 0, 1}, {0, 0, -1}, {0.25f, 0, 0}, {0, 0.25f, 0}, 8, 8};

TEST(EyePass, FootprintIsHalfAPixelAtTheSurface) {
    const EyeImage image = traced_eye_image(floor_of({}), kDown, 8, 64, mock::small_settings(1, 1));
    ASSERT_EQ(image.visible_points.size(), 64u);
    // Half width of the view at distance 1 is 0.25, so half a pixel is 0.25 / 8; rays off the axis
    // travel up to 6 % further.
    EXPECT_NEAR(image.mean_footprint(), 0.25 / 8, 0.03 * 0.25 / 8);
}

TEST(EyePass, MirrorsAreFollowedToTheNextReceiver) {
    mock::Material mirror;
    mirror.kind = mock::Material::Kind::Mirror;
    mirror.reflectance = {0.5f, 0.5f, 0.5f};
    const EyeImage image =
        traced_eye_image(floor_of(mirror), kDown, 8, 64, mock::small_settings(2, 1));
    ASSERT_EQ(image.visible_points.size(), 64u);
    for (const VisiblePoint& point : image.visible_points) {
        EXPECT_NEAR(point.position.z, 3, 1e-4);
        EXPECT_FLOAT_EQ(point.throughput.r, 0.5f);
    }
}

/// Choosing between storing and bouncing keeps the mean: throughputs of both outcomes together
/// carry the whole albedo, whatever the probability.
TEST(EyePass, ChoiceBetweenStoringAndBouncingIsUnbiased) {
    mock::Material both;
    both.kind = mock::Material::Kind::LambertAndMirror;
    both.specular = {0.3f, 0.3f, 0.3f};
    const EyeImage image =
        traced_eye_image(floor_of(both), kDown, 8, 64 * 500, mock::small_settings(3, 1));
    double stored = 0, bounced = 0;
    for (const VisiblePoint& point : image.visible_points) {
        (point.position.z < 1 ? stored : bounced) += point.throughput.r;
    }
    EXPECT_NEAR(stored / (64 * 500), 1, 0.02);
    EXPECT_NEAR(bounced / (64 * 500), 0.3, 0.01);
}

/// A lamp that glass reflects at 4 % is in each path, at 4 %: not in one of 25, whole.
TEST(EyePass, LampsAreLookedForBothWays) {
    mock::Scene scene;
    mock::Surface glass;
    glass.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    glass.material.kind = mock::Material::Kind::Glass;
    scene.add(glass);
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-2, -2, 3}, {0, 4, 0}, {4, 0, 0}};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    scene.finish();
    const EyeImage image = traced_eye_image(scene, kDown, 8, 64 * 50, mock::small_settings(5, 1));
    for (const Rgb& radiance : image.radiance)
        EXPECT_NEAR(radiance.r, 0.04 * 10, 0.01);
}

/// Shares of all ways are 1: a ball of glass, from outside and within, in front of a wall that
/// shines everywhere is as bright as the wall, path by path.
TEST(EyePass, BothWaysTogetherAreTheWhole) {
    mock::Scene scene;
    mock::Surface wall;
    wall.emitted = {2, 2, 2};
    wall.material.reflectance = {};
    scene.add_box({-4, -4, -4}, {4, 4, 4}, wall);
    mock::Surface ball;
    ball.shape = mock::Ball{{0, 0, 0}, 0.2f, false};
    ball.material.kind = mock::Material::Kind::Glass;
    scene.add(ball);
    scene.finish();
    Settings settings = mock::small_settings(6, 1);
    settings.direct_light_sampling = false;
    settings.max_eye_depth = 64;
    const EyeImage image = traced_eye_image(scene, kDown, 8, 64 * 50, settings);
    for (const Rgb& radiance : image.radiance)
        EXPECT_NEAR(radiance.r, 2, 2e-3);
}

TEST(EyePass, LambertianPointsKeepNoBsdf) {
    const EyeImage plain = traced_eye_image(floor_of({}), kDown, 8, 64, mock::small_settings(4, 1));
    for (const VisiblePoint& point : plain.visible_points)
        EXPECT_EQ(point.bsdf, nullptr);
    mock::Material hidden;
    hidden.hide_lambert = true;
    const EyeImage general =
        traced_eye_image(floor_of(hidden), kDown, 8, 64, mock::small_settings(4, 1));
    for (const VisiblePoint& point : general.visible_points)
        EXPECT_NE(point.bsdf, nullptr);
}

}  // namespace
}  // namespace aips::eye_pass_test
