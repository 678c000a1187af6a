// Protects motion blur end to end: a moving sphere covers each point for the share of the shutter's
// time that its path says, a moving camera sees the same, and photons see what eye paths see.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rendered_image.h"

namespace motion_scene_test {
namespace {

constexpr int kWidth = 48;

/// An orthographic view of x from -3 to 3, from above onto a black sphere of radius 1 before a
/// white sky; `camera` and `sphere` are what moves or places each.
std::string silhouette(const std::string& camera, const std::string& sphere) {
    return camera +
           R"(Camera "orthographic" "float screenwindow" [-3 3 -0.01 0.01]
Film "fleximage" "integer xresolution" [48] "integer yresolution" [8]
PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
SurfaceIntegrator "path"
WorldBegin
LightSource "infinite" "color L" [1 1 1]
ObjectBegin "ball"
Material "matte" "color Kd" [0 0 0]
Shape "sphere"
ObjectEnd
)" + sphere +
           "ObjectInstance \"ball\"\nWorldEnd\n";
}

double column_mean(const render::Image& image, std::size_t column) {
    const auto l = image.luminance();
    double sum = 0;
    for (std::size_t y = 0; y < image.height; ++y)
        sum += l[y * image.width + column];
    return sum / static_cast<double>(image.height);
}

/// Share of the time in which |x - c| < 1 for c from -1 to 1.
double coverage(double x) {
    return std::max(0.0, std::min(1.0, x + 1) - std::max(-1.0, x - 1)) / 2;
}

void expect_coverage(const std::string& text) {
    const render::Folder folder;
    const auto image =
        render::render(folder.write("scene.lxs", text), "--passes 256 --seed 5", folder);
    for (std::size_t i = 0; i < kWidth; ++i) {
        const double x = -3 + 6 * (static_cast<double>(i) + 0.5) / kWidth;
        // 2048 samples a column: four and a half standard deviations at most, and the pixel's
        // width.
        EXPECT_NEAR(1 - column_mean(image, i), coverage(x), 0.05) << "x = " << x;
    }
}

TEST(MotionScene, CoverageOfAMovingSphere) {
    expect_coverage(
        silhouette("LookAt 0 0 5  0 0 0  0 1 0\n",
                   "MotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n"));
}

TEST(MotionScene, CoverageFromAMovingCamera) {
    expect_coverage(
        silhouette("MotionBegin [0 1]\nLookAt 1 0 5  1 0 0  0 1 0\n"
                   "LookAt -1 0 5  -1 0 0  0 1 0\nMotionEnd\n",
                   ""));
}

/// A diffuse sphere that moves under a lamp, and what it reflects to the floor.
const char* const kLitScene = R"(LookAt 0 -6 4  0 0 -0.3  0 0 1
Camera "perspective" "float fov" [30]
Film "fleximage" "integer xresolution" [24] "integer yresolution" [18]
PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
SurfaceIntegrator "path"
WorldBegin
AttributeBegin
AreaLightSource "area" "color L" [10 10 10]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-1 -1 4 1 -1 4 1 1 4 -1 1 4]
AttributeEnd
Material "matte" "color Kd" [0.7 0.7 0.7]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-8 -8 0 8 -8 0 8 8 0 -8 8 0]
ObjectBegin "ball"
Material "matte" "color Kd" [0.8 0.8 0.8]
Shape "sphere" "float radius" [0.6]
ObjectEnd
MotionBegin [0 1]
Translate -1 0 0.7
Translate 1 0 1.2
MotionEnd
ObjectInstance "ball"
WorldEnd
)";

TEST(MotionScene, PhotonsSeeTheSameTimes) {
    const render::Folder folder;
    const auto scene = folder.write("scene.lxs", kLitScene);
    const auto path = render::render(scene, "--passes 400 --seed 3", folder);
    const auto photons =
        render::render(scene,
                       "--integrator aips --passes 250 --seed 4 --set aips.photonperpass=10000 "
                       "--set aips.directlightsampling=false",
                       folder);
    const auto a = path.block_means(6), b = photons.block_means(6);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(b[i] / a[i], 1, 0.08) << "block " << i;
}

}  // namespace
}  // namespace motion_scene_test
