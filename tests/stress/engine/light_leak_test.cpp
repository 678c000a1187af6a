// Protects the bounds on light that leaks from lit surfaces to dark ones within the radius of
// density estimation (docs/measured/stress.md): none through a wall, however thin; none to
// a parallel surface more than half a radius off; none to a surface turned by more than 45 degrees;
// and along the foot of an infinitely thin wall no more than the share of the gather disc that lies
// beyond, and none where photons are asked for what separates them (photonocclusion).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "render_mock.h"
#include "stress_case.h"

namespace aips::light_leak_test {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 8;
constexpr float kRadius = 0.25f;  // of the density estimation, scene units
/// Radiance that rounding may carry: the mock host's rays start without an offset, so that one that
/// grazes its surface may meet it again from behind. The lit side's radiance is above 0.05; such
/// light is 2e-8 at most in the long form.
constexpr double kRounding = 1e-7;
/// Mean of a segment's share of its disc over all distances of the chord up to the radius.
constexpr double kDiscBeyond = 2 / (3 * std::numbers::pi);

std::string number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

mock::Material material(bool compact) {
    mock::Material matte;
    matte.hide_lambert = !compact;
    return matte;
}

mock::Surface absorber(const mock::Quad& quad) {
    mock::Surface surface;
    surface.shape = quad;
    surface.material.reflectance = {0, 0, 0};
    return surface;
}

/// Lights what is below y = `y` (facing +y).
mock::Surface lamp_at(float x, float y, bool facing_up) {
    mock::Surface lamp = absorber(facing_up ? mock::Quad{{x, y, -1}, {0, 0, 2}, {1, 0, 0}}
                                            : mock::Quad{{x, y, -1}, {1, 0, 0}, {0, 0, 2}});
    lamp.emitted = {1, 1, 1};
    return lamp;
}

/// Mean radiance between columns of the image of x in [0, 1] at y = 0, seen from before the lamp at
/// y = -1. `occlusion`: photons are asked for what separates them; without it the other checks are
/// all that keeps light back.
double seen(const mock::Scene& scene, GuideKind guide, Mode mode, std::uint32_t to_column,
            bool occlusion = false) {
    const mock::Camera camera({0.5f, -0.9f, 0}, {0, 1, 0}, {0.5f / 0.9f, 0, 0},
                              {0, 0, -0.125f / 0.9f}, kWidth, kHeight);
    Settings settings = mock::small_settings(23, 20000);
    settings.guide = guide;
    settings.mode = mode;
    settings.direct_light_sampling = false;
    settings.photon_occlusion = occlusion;
    settings.start_radius = 1;
    const float footprint =
        mock::render(scene, camera, kWidth, kHeight, settings, 1).statistics.radius;
    settings.start_radius = double(kRadius) / double(footprint);
    const auto r = mock::render(scene, camera, kWidth, kHeight, settings, stress::sized(6, 60));
    EXPECT_NEAR(r.statistics.radius, kRadius, 0.02f * kRadius);
    EXPECT_TRUE(r.statistics.refused.empty());
    return mock::mean_luminance(r.film.image(), kWidth, 0, 0, to_column, kHeight);
}

/// A wall seen from its dark side, `thickness` behind which its other face is lit; `slant` tilts
/// that face, so that the wall is a wedge.
mock::Scene thin_wall(float thickness, float slant, bool compact) {
    mock::Scene scene;
    mock::Surface face;
    face.material = material(compact);
    face.shape = mock::Quad{{-1, 0, -1}, {2, 0, 0}, {0, 0, 2}};  // front: -y, the camera's side
    scene.add(face);
    if (thickness > 0) {
        face.shape = mock::Quad{{-1, thickness, -1}, {0, 0, 2}, {2, slant, 0}};  // front: +y
        scene.add(face);
    }
    scene.add(lamp_at(-0.5f, 1.5f, false));
    scene.finish();
    return scene;
}

/// Sheets that face the camera: a dark one at y = 0 for x > 0, and beside it one that is lit. It
/// starts `gap` behind the dark one's edge and falls back from it by an angle. A black wall of no
/// thickness along x = 0 parts them.
mock::Scene lit_neighbour(float gap, double degrees, bool compact) {
    mock::Scene scene;
    mock::Surface sheet;
    sheet.material = material(compact);
    sheet.shape = mock::Quad{{0, 0, -1}, {1, 0, 0}, {0, 0, 2}};
    scene.add(sheet);
    const auto angle = float(degrees * std::numbers::pi / 180);
    const Vec3 along{-std::cos(angle), std::sin(angle), 0};
    sheet.shape = mock::Quad{Vec3{0, gap, -1} + along, -along, {0, 0, 2}};
    scene.add(sheet);
    scene.add(absorber({{0, -1.5f, -1}, {0, 1.5f + gap, 0}, {0, 0, 2}}));
    scene.add(lamp_at(-1.1f, -1, true));
    scene.finish();
    return scene;
}

/// What the lit sheet would show if it were seen: the dark one's light without the wall between.
double bright(GuideKind guide) {
    mock::Scene scene;
    mock::Surface sheet;
    sheet.shape = mock::Quad{{-1, 0, -1}, {2, 0, 0}, {0, 0, 2}};
    scene.add(sheet);
    scene.add(lamp_at(0.1f, -1, true));
    scene.finish();
    return seen(scene, guide, Mode::Progressive, kWidth / 4);
}

TEST(StressLightLeak, NoneThroughAWallHoweverThin) {
    double most = 0;
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        for (const float share : {0.0f, 1e-5f, 1e-3f, 0.1f, 0.45f}) {
            for (const bool compact : {true, false}) {
                const double leaked =
                    seen(thin_wall(share * kRadius, 0, compact), guide, Mode::Progressive, kWidth);
                EXPECT_LE(leaked, kRounding) << mock::name(guide) << ", t / r " << share;
                most = std::max(most, leaked);
            }
        }
    }
    for (const Mode mode : {Mode::PhotonMap, Mode::Ppm})
        EXPECT_LE(seen(thin_wall(0.1f * kRadius, 0, true), GuideKind::None, mode, kWidth),
                  kRounding);
    EXPECT_LE(
        seen(thin_wall(0.1f * kRadius, 0.3f, true), GuideKind::None, Mode::Progressive, kWidth),
        kRounding);
    EXPECT_GT(bright(GuideKind::None), 0.05);
    stress::record("walls 0 to 0.45 radii thick, three guides",
                   "radiance " + number(most) + " of at most 1e-7 on the dark side");
}

/// The slab around the tangent plane is half a radius to each side.
TEST(StressLightLeak, NoneFromAParallelSurfaceHalfARadiusOff) {
    const double lit = bright(GuideKind::None);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        for (const bool compact : {true, false}) {
            EXPECT_EQ(
                seen(lit_neighbour(0.52f * kRadius, 0, compact), guide, Mode::Progressive, kWidth),
                0)
                << mock::name(guide);
        }
    }
    const double nearer = seen(lit_neighbour(0.45f * kRadius, 0, true), GuideKind::None,
                               Mode::Progressive, kWidth / 4);
    EXPECT_GT(nearer, 0) << "the case would show a leak if there were one";
    EXPECT_LT(nearer / lit, kDiscBeyond);
    stress::record("a lit step 0.52 and 0.45 radii behind a dark one",
                   "0 of at most 0; " + number(nearer / lit) + " of at most 0.212");
}

TEST(StressLightLeak, NoneFromASurfaceTurnedBy45Degrees) {
    const double lit = bright(GuideKind::None);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        for (const double degrees : {47.0, 60.0, 80.0}) {
            EXPECT_EQ(seen(lit_neighbour(0, degrees, true), guide, Mode::Progressive, kWidth), 0)
                << mock::name(guide) << ", " << degrees;
        }
    }
    const double less =
        seen(lit_neighbour(0, 40, true), GuideKind::None, Mode::Progressive, kWidth / 4);
    EXPECT_GT(less, 0) << "the case would show a leak if there were one";
    stress::record("a lit surface turned by 47, 60, 80 and by 40 degrees",
                   "0 of at most 0; " + number(less / lit) + " at 40 degrees");
}

/// What no check of normals, sides or planes can tell: one floor on both sides of a wall without
/// thickness. The leak is what the disc holds of the lit side, and ends a radius from the wall.
TEST(StressLightLeak, AtTheFootOfAWallTheDiscBeyondIt) {
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        const double lit = bright(guide);
        // A quarter of the image is the radius.
        const double strip = seen(lit_neighbour(0, 0, true), guide, Mode::Progressive, kWidth / 4);
        const double all = seen(lit_neighbour(0, 0, true), guide, Mode::Progressive, kWidth);
        EXPECT_LT(strip / lit, kDiscBeyond) << mock::name(guide);
        EXPECT_GT(strip / lit, 0.6 * kDiscBeyond) << mock::name(guide);
        EXPECT_NEAR(all, strip / 4, 0.02 * strip) << "beyond the radius there is none";
        const double asked =
            seen(lit_neighbour(0, 0, true), guide, Mode::Progressive, kWidth / 4, true);
        EXPECT_LT(asked / lit, 1e-3) << mock::name(guide);
        stress::record("a strip one radius wide at the foot of a wall without thickness",
                       "leak " + number(strip / lit) + " of at most 0.212");
    }
}

}  // namespace
}  // namespace aips::light_leak_test
