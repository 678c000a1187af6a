// Protects caustics on glossy lobes: photons and bounces bring the same light, and what a light
// without extent sends there through glass is not lost.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::caustics_on_gloss_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kSize = 16;

struct Lit {
    bool by_point = false;      ///< else by a quad that bounces find
    bool through_glass = true;  ///< that bends nothing, but stops shadow rays
    bool mixed = false;         ///< a matte lobe beside the glossy one
};

/// A glossy floor below a light, and a glossy wall in which it is seen.
mock::Scene floor_and_wall(const Lit& lit) {
    mock::Material gloss;
    gloss.kind = lit.mixed ? Kind::Sheet : Kind::Phong;
    gloss.exponent = 8;
    if (lit.mixed) gloss.glossy = {0.4f, 0.4f, 0.4f};
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    surface.material = gloss;
    scene.add(surface);
    surface.shape = mock::Quad{{-1, 1, 0}, {2, 0, 0}, {0, 0, 1.2f}};
    scene.add(surface);
    if (lit.by_point) {
        scene.add_point_light({0, 0, 2}, {3, 3, 3});
    } else {
        mock::Surface lamp;
        lamp.shape = mock::Quad{{-0.5f, -0.5f, 2}, {0, 1, 0}, {1, 0, 0}};
        lamp.material.reflectance = {0, 0, 0};
        lamp.emitted = {5, 5, 5};
        scene.add(lamp);
    }
    if (lit.through_glass) {
        mock::Surface sheet;
        sheet.shape = mock::Quad{{-3, -3, 1.5f}, {6, 0, 0}, {0, 6, 0}};
        sheet.material.kind = Kind::Glass;
        sheet.material.index = 1.0001f;
        scene.add(sheet);
    }
    scene.finish();
    return scene;
}

const mock::Camera kAtFloor{{0, -1, 1}, {0, 0.6f, -0.8f}, {0.2f, 0, 0}, {0, 0.16f, 0.12f}, kSize,
                            kSize};
const mock::Camera kAtWall{{0, -1, 0.6f}, {0, 1, 0}, {0.2f, 0, 0}, {0, 0, 0.2f}, kSize, kSize};

/// Its standard deviation over seeds is below 0.7 % in each case.
double mean_of(const mock::Scene& scene, const mock::Camera& camera, bool by_photons,
               bool stored = false) {
    Settings settings = mock::small_settings(31, by_photons ? 10000 : 2000);
    settings.start_radius = 1;
    settings.caustics_on_gloss = by_photons;
    settings.store_glossy = stored;
    return mock::render(scene, camera, kSize, kSize, settings, 480).film.mean();
}

/// The quad fills a good part of the sky: bounces find it often. Without the glass it would be
/// direct light, whose mean is known well.
TEST(CausticsOnGloss, PhotonsAndBouncesBringTheSame) {
    for (const bool mixed : {false, true}) {
        const mock::Scene bare = floor_and_wall({.through_glass = false, .mixed = mixed});
        const mock::Scene behind = floor_and_wall({.mixed = mixed});
        for (const mock::Camera& camera : {kAtFloor, kAtWall}) {
            const double direct = mean_of(bare, camera, false);
            EXPECT_NEAR(mean_of(behind, camera, true) / direct, 1, 0.02);
            EXPECT_NEAR(mean_of(behind, camera, false) / direct, 1, 0.02);
        }
    }
}

/// No bounce meets a point.
TEST(CausticsOnGloss, OfAPointAreFound) {
    const mock::Scene bare = floor_and_wall({.by_point = true, .through_glass = false});
    const mock::Scene behind = floor_and_wall({.by_point = true});
    for (const mock::Camera& camera : {kAtFloor, kAtWall}) {
        const double direct = mean_of(bare, camera, false);
        EXPECT_GT(direct, 0);
        EXPECT_NEAR(mean_of(behind, camera, true) / direct, 1, 0.02);
        EXPECT_NEAR(mean_of(behind, camera, true, true) / direct, 1, 0.02);
        EXPECT_LT(mean_of(behind, camera, false), 0.01 * direct);
    }
}

/// Eye paths have two visible points each: one on the wall, one on the floor.
TEST(CausticsOnGloss, MemoryStaysBelowTheBound) {
    constexpr std::uint32_t kMany = 400;
    const mock::Scene scene = floor_and_wall({.mixed = true});
    mock::Camera camera{{0, -1, 0.6f}, {0, 1, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, kMany, kMany};
    const Settings settings = mock::small_settings(3, 4000);
    const auto r = mock::render(scene, camera, kMany, kMany, settings, 10);
    EXPECT_LE(r.statistics.memory_bytes, r.statistics.memory_bound_bytes);
}

}  // namespace
}  // namespace aips::caustics_on_gloss_test
