// Protects the cameras: where rays go for known film positions, that images are not mirrored, lens,
// clipping depths and pixel footprints.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test::camera_test {
namespace {

/// World to camera as LookAt of the scene language makes it: x right, y up, z forward.
Matrix look_at(const Imath::V3d& eye, const Imath::V3d& target, const Imath::V3d& up) {
    const Imath::V3d forward = (target - eye).normalized();
    const Imath::V3d right = forward.cross(up).normalized();
    const Imath::V3d top = right.cross(forward);
    const Matrix to_world(right.x, right.y, right.z, 0, top.x, top.y, top.z, 0, forward.x,
                          forward.y, forward.z, 0, eye.x, eye.y, eye.z, 1);
    return to_world.inverse();
}

struct CameraScene {
    SceneContents contents = scene_of_size(200, 100);
    RecordedDiagnostics diagnostics;

    CameraScene(const std::string& plugin, std::vector<ParameterValue> values) {
        set_option(contents, "Camera", plugin, std::move(values)).transform =
            look_at({1, -4, 2}, {1, 0, 2}, {0, 0, 1});
    }
    std::unique_ptr<SceneCamera> camera() {
        const auto film = make_film(contents, diagnostics);
        return make_camera(contents, *film, diagnostics);
    }
};

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

CameraRay ray_at(const Camera& camera, float x, float y, const Vec2& lens = Vec2(0.5f)) {
    return camera.generate({Vec2(x, y), lens}, 0);
}

TEST(PerspectiveCamera, FovSpansTheShorterAxis) {
    CameraScene scene("perspective", {real("fov", 60)});
    const auto camera = scene.camera();
    const auto tangent = static_cast<float>(std::tan(std::numbers::pi / 6));
    expect_near(ray_at(*camera, 100, 50).ray.origin, Vec3(1, -4, 2));
    expect_near(ray_at(*camera, 100, 50).ray.direction, Vec3(0, 1, 0));
    // Film y grows downwards, world z upwards: the image's top sees up.
    expect_near(ray_at(*camera, 100, 0).ray.direction, Vec3(0, 1, tangent).normalized());
    expect_near(ray_at(*camera, 100, 100).ray.direction, Vec3(0, 1, -tangent).normalized());
    // Looking along +y with z up, +x is to the right: no mirror image.
    expect_near(ray_at(*camera, 200, 50).ray.direction, Vec3(2 * tangent, 1, 0).normalized());
}

TEST(PerspectiveCamera, PortraitImagesSpanTheWidth) {
    CameraScene scene("perspective", {real("fov", 90)});
    scene.contents.options["Film"].parameters.values = {integer("xresolution", 50),
                                                        integer("yresolution", 100)};
    const auto camera = scene.camera();
    expect_near(ray_at(*camera, 50, 50).ray.direction, Vec3(1, 1, 0).normalized());
    expect_near(ray_at(*camera, 25, 0).ray.direction, Vec3(0, 1, 2).normalized());
}

TEST(PerspectiveCamera, ScreenWindowShiftsTheImage) {
    CameraScene scene("perspective",
                      {real("fov", 90), numbers("float", "screenwindow", {-1, 0.5, -0.5, 0.6})});
    const auto camera = scene.camera();
    expect_near(ray_at(*camera, 0, 0).ray.direction, Vec3(-1, 1, 0.6f).normalized());
    expect_near(ray_at(*camera, 200, 100).ray.direction, Vec3(0.5f, 1, -0.5f).normalized());
}

TEST(PerspectiveCamera, CropWindowSeesItsPartOfTheImage) {
    CameraScene whole("perspective", {real("fov", 40)});
    CameraScene part("perspective", {real("fov", 40)});
    part.contents.options["Film"].parameters.values.push_back(
        numbers("float", "cropwindow", {0.25, 0.75, 0.5, 1}));
    const auto a = whole.camera(), b = part.camera();
    expect_near(ray_at(*a, 60, 70).ray.direction, ray_at(*b, 10, 20).ray.direction, 1e-7f);
}

TEST(PerspectiveCamera, LensRaysMeetInThePlaneOfFocus) {
    CameraScene scene("perspective",
                      {real("fov", 50), real("lensradius", 0.3), real("focaldistance", 3)});
    const auto camera = scene.camera();
    const CameraRay centre = ray_at(*camera, 30, 80);
    const Vec3 sharp = centre.ray.origin + centre.ray.direction * (3 / centre.ray.direction.y);
    float widest = 0;
    for (int i = 0; i < 10; ++i) {
        for (int j = 0; j < 10; ++j) {
            const Vec2 u(0.05f + 0.1f * static_cast<float>(i),
                         0.05f + 0.1f * static_cast<float>(j));
            const CameraRay r = ray_at(*camera, 30, 80, u);
            widest = std::max(widest, (r.ray.origin - Vec3(1, -4, 2)).length());
            EXPECT_EQ(r.ray.origin.y, -4);
            expect_near(r.ray.origin + r.ray.direction * (3 / r.ray.direction.y), sharp);
            EXPECT_NEAR(r.ray.direction.length(), 1, 1e-6f);
        }
    }
    EXPECT_LE(widest, 0.3f);
    EXPECT_GT(widest, 0.25f);
}

TEST(PerspectiveCamera, HasALensIfItHasAWidth) {
    EXPECT_TRUE(CameraScene("perspective", {real("lensradius", 0.3)}).camera()->has_lens());
    CameraScene without("perspective", {});
    const auto camera = without.camera();
    EXPECT_FALSE(camera->has_lens());
    const Ray a = ray_at(*camera, 30, 80, Vec2(0.1f)).ray, b = ray_at(*camera, 30, 80).ray;
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.direction, b.direction);
}

TEST(PerspectiveCamera, LensIsCoveredUniformly) {
    // Equal areas of the square go to equal areas of the disk: half of a fine grid lies within
    // radius / sqrt(2).
    CameraScene scene("perspective", {real("lensradius", 2)});
    const auto camera = scene.camera();
    int inner = 0;
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const Vec2 u((static_cast<float>(i) + 0.5f) / 100,
                         (static_cast<float>(j) + 0.5f) / 100);
            const float r = (ray_at(*camera, 100, 50, u).ray.origin - Vec3(1, -4, 2)).length();
            inner += r < std::numbers::sqrt2_v<float> ? 1 : 0;
        }
    }
    EXPECT_NEAR(inner, 5000, 150);
}

TEST(PerspectiveCamera, ClippingDepthsBoundTheRay) {
    CameraScene scene("perspective", {real("fov", 90), real("hither", 0.5), real("yon", 10)});
    const auto camera = scene.camera();
    const Ray ray = ray_at(*camera, 0, 0).ray;
    EXPECT_NEAR(ray.origin.y, -3.5f, 1e-5f);
    EXPECT_NEAR((ray.origin + ray.direction * ray.t_max).y, 6, 1e-4f);
    CameraScene open("perspective", {});
    EXPECT_TRUE(std::isinf(ray_at(*open.camera(), 0, 0).ray.t_max));
}

TEST(PerspectiveCamera, FootprintIsHalfThePixel) {
    CameraScene scene("perspective", {real("fov", 90)});
    const auto camera = scene.camera();
    // Screen of height 2 at depth 1 on 100 pixels: half a pixel is 0.01 straight ahead.
    EXPECT_NEAR(ray_at(*camera, 100, 50).spread, 0.01f, 1e-7f);
    EXPECT_EQ(ray_at(*camera, 100, 50).width, 0);
    // The solid angles of all pixels make up that of the screen, a rectangle of tangents 2 and 1.
    double sum = 0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 200; ++x) {
            const double side =
                2.0 *
                ray_at(*camera, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).spread;
            sum += side * side;
        }
    }
    EXPECT_NEAR(sum, 4 * std::asin(2.0 / std::sqrt(5.0) * 1.0 / std::sqrt(2.0)), 1e-4);
}

TEST(OrthographicCamera, RaysAreParallel) {
    CameraScene scene("orthographic", {numbers("float", "screenwindow", {-4, 4, -2, 2})});
    const auto camera = scene.camera();
    const CameraRay corner = ray_at(*camera, 200, 0);
    expect_near(corner.ray.origin, Vec3(5, -4, 4));
    expect_near(corner.ray.direction, Vec3(0, 1, 0));
    EXPECT_NEAR(corner.width, 0.02f, 1e-7f);
    EXPECT_EQ(corner.spread, 0);
}

TEST(OrthographicCamera, ScaleInTheTransformScalesTheImage) {
    CameraScene scene("orthographic", {});
    Matrix scale;
    scale.setScale(Imath::V3d(0.5, 0.5, 0.5));  // world to camera: the view grows twofold
    OptionStatement& option = scene.contents.options["Camera"];
    option.transform = option.transform * scale;
    const CameraRay corner = ray_at(*scene.camera(), 200, 0);
    expect_near(corner.ray.origin, Vec3(1 + 4, -4, 2 + 2));
    EXPECT_NEAR(corner.width, 0.02f, 1e-7f);
    EXPECT_NEAR(corner.ray.direction.length(), 1, 1e-6f);
}

TEST(EnvironmentCamera, CoversTheSphereWithForwardInTheCentre) {
    CameraScene scene("environment", {});
    const auto camera = scene.camera();
    expect_near(ray_at(*camera, 100, 50).ray.direction, Vec3(0, 1, 0));
    expect_near(ray_at(*camera, 150, 50).ray.direction, Vec3(1, 0, 0));
    expect_near(ray_at(*camera, 0, 50).ray.direction, Vec3(0, -1, 0));
    expect_near(ray_at(*camera, 30, 0).ray.direction, Vec3(0, 0, 1));
    double sum = 0;
    for (int y = 0; y < 100; ++y) {
        const double side = 2.0 * ray_at(*camera, 7, static_cast<float>(y) + 0.5f).spread;
        sum += 200 * side * side;
    }
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 0.01);
}

// As pbrt-v4's spherical camera, whose y axis is up.
TEST(EnvironmentCamera, EqualAreaPixelsSeeAsMuchEach) {
    CameraScene scene("environment", {text("mapping", "equalarea")});
    const auto camera = scene.camera();
    expect_near(ray_at(*camera, 100, 50).ray.direction, Vec3(0, 0, 1));
    expect_near(ray_at(*camera, 100, 100).ray.direction, Vec3(0, 1, 0));
    expect_near(ray_at(*camera, 200, 50).ray.direction, Vec3(1, 0, 0));
    expect_near(ray_at(*camera, 100, 0).ray.direction, Vec3(0, -1, 0));
    expect_near(ray_at(*camera, 200, 100).ray.direction, Vec3(0, 0, -1));
    const double side = 2.0 * ray_at(*camera, 33, 44).spread;
    EXPECT_NEAR(200 * 100 * side * side, 4 * std::numbers::pi, 1e-4);
    // Moments of directions are those of a sphere.
    double squares = 0, fourths = 0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 200; ++x) {
            const float z = ray_at(*camera, float(x) + 0.5f, float(y) + 0.5f).ray.direction.z;
            squares += double(z) * z;
            fourths += std::pow(double(z), 4);
        }
    }
    EXPECT_NEAR(squares / 20000, 1 / 3.0, 1e-3);
    EXPECT_NEAR(fourths / 20000, 1 / 5.0, 1e-3);
}

TEST(Camera, GivesTimeShutterAndMedia) {
    CameraScene scene("perspective", {real("shutteropen", 0.25), real("shutterclose", 0.5)});
    const auto camera = scene.camera();
    EXPECT_EQ(camera->shutter_open(), 0.25f);
    EXPECT_EQ(camera->shutter_close(), 0.5f);
    const CameraRay ray = camera->generate({Vec2(3, 4), Vec2(0.1f)}, 0.375f);
    EXPECT_EQ(ray.ray.time, 0.375f);
    EXPECT_EQ(ray.ray.media, EnteredMedia());
    camera->set_media(EnteredMedia().entered(2));
    EXPECT_EQ(camera->generate({Vec2(3, 4), Vec2(0.1f)}, 0).ray.media, EnteredMedia().entered(2));
}

}  // namespace
}  // namespace lxs::test::camera_test
