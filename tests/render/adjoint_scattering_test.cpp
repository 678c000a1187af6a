// Protects: photons scatter by the adjoint Bsdf in whole renders. Where interpolated normals are
// strongly tilted, and where camera and lamp are inside a dielectric, `path` and `aips` have the
// same expectation, with and without a guide.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>

#include "seeded_renders.h"
#include "test_form.h"

namespace adjoint_scattering_test {
namespace {

constexpr int kSize = 48, kBlock = 12;

/// Four have a variance too uncertain to find what is planted on every processor (whose rounding
/// decides what the seeds are).
unsigned seeds() {
    return statistics::sized(8u, 12u);
}

/// What the density estimate may be off by. Radii are a pixel at most where light has edges, which
/// moves it by a small share of a block's 12 pixels; four pixels on the smoothly lit ceiling.
constexpr double kRadiusBias = 0.005;

std::string film_and_camera(const std::string& look_at, double fov, const std::string& medium) {
    return "Film \"fleximage\" \"integer xresolution\" [" + std::to_string(kSize) +
           "] \"integer yresolution\" [" + std::to_string(kSize) + "]\n" + medium + "LookAt " +
           look_at + "\nCamera \"perspective\" \"float fov\" [" + std::to_string(fov) + "]\n" +
           "PixelFilter \"box\" \"float xwidth\" [0.5] \"float ywidth\" [0.5]\n"
           "Renderer \"sppm\"\nSurfaceIntegrator \"aips\"\nWorldBegin\n";
}

std::string part(const std::string& content) {
    return "AttributeBegin\n" + content + "AttributeEnd\n";
}

/// The walls of [-a, a] x [-a, a] x [low, high], seen from inside.
std::string box(double a, double low, double high) {
    std::string p;
    for (const double z : {low, high}) {
        for (const auto& [x, y] : {std::pair{-a, -a}, {a, -a}, {a, a}, {-a, a}})
            p += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "  ";
    }
    return "Shape \"trianglemesh\" \"integer triindices\" [0 1 2 0 2 3  4 6 5 4 7 6  0 5 1 0 4 5  "
           "1 6 2 1 5 6  2 7 3 2 6 7  3 4 0 3 7 4] \"point P\" [" +
           p + "]\n";
}

/// A square lamp of half side `a` at height z that shines down.
std::string ceiling_lamp(double a, double z) {
    const std::string s = std::to_string(a), h = std::to_string(z);
    return part(
        "AreaLightSource \"area\" \"color L\" [5 5 5] \"float power\" [0] \"float efficacy\" [0]\n"
        "Material \"matte\" \"color Kd\" [0 0 0]\n"
        "Shape \"trianglemesh\" \"integer triindices\" [0 2 1 0 3 2] \"point P\" [-" +
        s + " -" + s + " " + h + "  " + s + " -" + s + " " + h + "  " + s + " " + s + " " + h +
        "  -" + s + " " + s + " " + h + "]\n");
}

/// A ground of 7 x 7 vertices over [-1, 1]^2, bumps 0.04 high, with interpolated normals that lean
/// towards +x, by 11 to 45 degrees: light from there is brighter on it than its geometry tells.
std::string leaning_ground() {
    constexpr int kVertices = 7;
    std::string p, n, indices;
    for (int i = 0; i < kVertices * kVertices; ++i) {
        const int column = i % kVertices, row = i / kVertices;
        const double x = column / 3.0 - 1, y = row / 3.0 - 1;
        const double height = 0.02 * ((column + row) % 2 ? 1 : -1);
        const double lean = 0.6 + 0.4 * std::sin(2.1 * column + row);
        p += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(height) + "  ";
        n += std::to_string(lean) + " " + std::to_string(0.3 * std::cos(1.7 * row)) + " 1  ";
        if (column + 1 == kVertices || row + 1 == kVertices) continue;
        for (const int corner : {0, 1, kVertices + 1, 0, kVertices + 1, kVertices})
            indices += std::to_string(i + corner) + " ";
    }
    return "Shape \"trianglemesh\" \"integer triindices\" [" + indices + "] \"point P\" [" + p +
           "] \"normal N\" [" + n + "]\n";
}

/// An icosahedron of radius r with the normals of its sphere: tilts of up to 37 degrees.
std::string smooth_icosahedron(double r) {
    constexpr double kGolden = 1.618033988749895;
    const double scale = r / std::sqrt(1 + kGolden * kGolden);
    std::string p;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            std::array<double, 3> v{};
            v[std::size_t(axis)] = corner & 1 ? scale : -scale;
            v[std::size_t(axis + 1) % 3] = (corner & 2 ? scale : -scale) * kGolden;
            for (const double coordinate : v)
                p += std::to_string(coordinate) + " ";
        }
    }
    return "Shape \"trianglemesh\" \"integer triindices\" [0 4 1  0 1 6  0 8 4  0 6 9  0 9 8  "
           "1 4 10  1 11 6  1 10 11  2 3 5  2 7 3  2 5 8  2 9 7  2 8 9  3 10 5  3 7 11  3 11 10  "
           "4 8 5  4 5 10  6 7 9  6 11 7] \"point P\" [" +
           p + "] \"normal N\" [" + p + "]\n";
}

constexpr const char* kWalls = "Material \"matte\" \"color Kd\" [0.6 0.5 0.4]\n";
constexpr const char* kMatte = "Material \"matte\" \"color Kd\" [0.7 0.7 0.7]\n";
constexpr const char* kGlass = "Material \"glass\" \"float index\" [1.5]\n";

/// Lights nothing but the ground and the ball.
constexpr const char* kSpot =
    "LightSource \"spot\" \"point from\" [2 0 2] \"point to\" [0 0 0.1] \"float coneangle\" [18] "
    "\"float conedeltaangle\" [5] \"color L\" [10 10 10]\n";
/// Large enough to be met by scattered rays of `path` that have passed the ball.
std::string near_lamp() {
    return part("Translate 1.1 0 1.2\nRotate 45 0 1 0\n" + ceiling_lamp(0.25, 0));
}
/// Sees the middle of the ceiling, from below.
constexpr const char* kAtCeiling = "0 0 0.85  0 0 1.2  0 1 0";
/// Sees the ground where light falls through the ball.
constexpr const char* kAtGround = "-0.3 0 0.45  -0.3 0 0  0 1 0";

/// The leaning ground under a ceiling that gets all its light from it and from `ball` (a material)
/// between them; `lamp` is aside.
std::string smooth_meshes(const std::string& ball, const std::string& lamp,
                          const std::string& look_at) {
    return film_and_camera(look_at, 100, "") + part(kMatte + leaning_ground()) +
           part(std::string(kWalls) +
                "Shape \"trianglemesh\" \"integer triindices\" [0 2 1 0 3 2] \"point P\" "
                "[-0.8 -0.8 1.2  0.8 -0.8 1.2  0.8 0.8 1.2  -0.8 0.8 1.2]\n") +
           part("Translate 0.2 0 0.5\n" + ball + smooth_icosahedron(0.3)) + lamp + "WorldEnd\n";
}

/// A room seen out of a ball of absorbing glass that holds camera, lamp and a matte ball; a second
/// lamp shines in from the room.
std::string room_seen_from_inside_glass() {
    return film_and_camera("0 -0.8 0  0 0 0  0 0 1", 70,
                           "MakeNamedVolume \"amber\" \"clear\" \"float fresnel\" [1.5] \"color "
                           "absorption\" [0.05 0.1 0.3]\nExterior \"amber\"\n") +
           part("Exterior \"\"\n" + std::string(kWalls) + box(1.6, -1.6, 1.6)) +
           part("Exterior \"\"\n" + ceiling_lamp(0.8, 1.55)) +
           part(
               "Exterior \"\"\nInterior \"amber\"\nMaterial \"glass2\"\n"
               "Shape \"sphere\" \"float radius\" [1]\n") +
           part("Translate -0.2 0.2 -0.2\n" + std::string(kMatte) +
                "Shape \"sphere\" \"float radius\" [0.4]\n") +
           part(
               "Translate 0.45 0.1 0.35\n"
               "AreaLightSource \"area\" \"color L\" [3 3 3] \"float power\" [0] \"float "
               "efficacy\" [0]\nMaterial \"matte\" \"color Kd\" [0.3 0.3 0.3]\n"
               "Shape \"sphere\" \"float radius\" [0.25]\n") +
           "WorldEnd\n";
}

/// What a comparison takes to find differences of the mean of 1 to 5 %.
struct Effort {
    std::string photons, radius;  ///< photon paths a pass; radius in footprints
};

/// 17 tests a guide at a family-wise significance of 1 %, fixed seeds.
void check(const std::string& name, const std::string& text, const Effort& effort) {
    const render::Folder folder;
    const auto scene = folder.path() / "scene.lxs";
    std::ofstream(scene) << text;
    const auto reference =
        render::seeded_block_means(scene, "--integrator path --set path.maxdepth=64 --passes 40",
                                   folder, {.first = 100, .count = seeds()}, kBlock);
    const double planted = statistics::sized(0.07, 0.05);
    for (const std::string guide : {"none", "paper", "adaptive"}) {
        const auto photons = render::seeded_block_means(
            scene,
            "--passes 4 --set aips.alpha=1 --set aips.maxphotondepth=64 --set aips.maxeyedepth=64 "
            "--set aips.photonperpass=" +
                effort.photons + " --set aips.startradius=" + effort.radius +
                " --set aips.guide=" + guide,
            folder, {.first = 200, .count = seeds()}, kBlock);
        const auto same = statistics::compare(reference, photons, 0.01, kRadiusBias);
        std::cout << name << ", guide " << guide << ": " << same.describe() << "\n";
        EXPECT_FALSE(same.differs()) << name << ", guide " << guide << ": " << same.describe();
        const auto biased = statistics::compare(reference, statistics::scaled(photons, 1 + planted),
                                                0.01, kRadiusBias);
        EXPECT_TRUE(biased.differs()) << "a planted bias went unnoticed";
    }
}

// Without the factor for shading normals: 26 % off and 7 % off; with the index ratio on the photon
// side too: 11 % off inside the glass.
TEST(AdjointScattering, MatteMeshesWithTiltedNormals) {
    check("matte meshes", smooth_meshes(kMatte, kSpot, kAtCeiling), {"60000", "4"});
}
TEST(AdjointScattering, GlassMeshWithTiltedNormals) {
    check("glass mesh", smooth_meshes(kGlass, near_lamp(), kAtGround), {"150000", "1"});
}
TEST(AdjointScattering, CameraAndLampInsideGlass) {
    check("inside glass", room_seen_from_inside_glass(), {"20000", "0.5"});
}

}  // namespace
}  // namespace adjoint_scattering_test
