// Protects images of surfaces that are hard to trace: coincident ones, lamps within walls, needles
// and surfaces without area, turned normals, grazing light, glass turned inside out, nested and
// overlapping glass, and scenes whose bounds are no box. Each renders without NaN, infinite or
// negative pixels, with the energy of the same scene in a clean form, or of a closed one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render_mock.h"
#include "spoiled_scene.h"
#include "stress_case.h"

namespace aips::hard_surfaces_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kWidth = 16, kHeight = 12;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Way {
    GuideKind guide = GuideKind::None;
    Mode mode = Mode::Progressive;
};

std::vector<Way> ways() {
    return {{GuideKind::None, Mode::Progressive},
            {GuideKind::Paper, Mode::Progressive},
            {GuideKind::Adaptive, Mode::Progressive},
            {GuideKind::Adaptive, Mode::PhotonMap},
            {GuideKind::None, Mode::Ppm}};
}

Settings settings_for(const Way& way) {
    Settings settings = mock::small_settings(29, 6000);
    settings.guide = way.guide;
    settings.mode = way.mode;
    return settings;
}

/// Renders and checks every pixel. The view is of the whole box.
mock::Rendering render(const aips::Scene& scene, const Way& way) {
    const auto camera = mock::camera_along_y({0, -0.95f, 0}, 1, kWidth, kHeight);
    auto r = mock::render(scene, camera, kWidth, kHeight, settings_for(way), stress::sized(8, 60));
    for (const Rgb& pixel : r.film.image())
        EXPECT_TRUE(is_valid_radiance(pixel)) << mock::name(way.guide) << int(way.mode);
    return r;
}

mock::Surface lamp(float z) {
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-0.5f, -0.5f, z}, {0, 1, 0}, {1, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {3, 3, 3};
    return lamp;
}

/// A white box with a lamp and more surfaces.
mock::Scene box(const std::vector<mock::Surface>& more, float lamp_z = 0.98f) {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    scene.add(lamp(lamp_z));
    for (const mock::Surface& surface : more)
        scene.add(surface);
    scene.finish();
    return scene;
}

mock::Surface matte(const mock::Quad& quad) {
    mock::Surface surface;
    surface.shape = quad;
    return surface;
}

/// Largest difference of the means over all ways, as a share.
double worst_difference(const mock::Scene& hard, const mock::Scene& clean) {
    double worst = 0;
    for (const Way& way : ways()) {
        const auto r = render(hard, way);
        EXPECT_TRUE(r.statistics.refused.empty());
        worst = std::max(worst, std::abs(r.film.mean() / render(clean, way).film.mean() - 1));
    }
    return worst;
}

/// What is hard must not change the mean by more than noise.
void expect_same(const std::string& what, const std::vector<const mock::Scene*>& hard,
                 const mock::Scene& clean) {
    constexpr double kBound = 0.02;
    double worst = 0;
    for (const mock::Scene* scene : hard)
        worst = std::max(worst, worst_difference(*scene, clean));
    EXPECT_LE(worst, kBound) << what;
    stress::record(what, "mean off by " + std::to_string(worst) + " of at most 0.02");
}

TEST(StressSurfaces, CoincidentSheets) {
    const mock::Quad sheet{{-0.5f, 0.3f, -0.8f}, {1, 0, 0}, {0, 0, 1}};
    const mock::Quad turned{sheet.corner, sheet.edge_v, sheet.edge_u};
    const mock::Scene one = box({matte(sheet)});
    const mock::Scene twice = box({matte(sheet), matte(sheet)});
    const mock::Scene back_to_back = box({matte(sheet), matte(turned)});
    expect_same("a sheet twice, and back to back", {&twice, &back_to_back}, one);
}

/// Which of both a ray meets is the host's choice: light may be lost to the wall, none is made.
TEST(StressSurfaces, LampWithinAWall) {
    const mock::Scene within = box({}, 1), before = box({});
    double least = 1;
    for (const Way& way : ways()) {
        const auto r = render(within, way);
        EXPECT_TRUE(r.statistics.refused.empty());
        least = std::min(least, r.film.mean() / render(before, way).film.mean());
        EXPECT_LT(r.film.mean(), 1.02 * render(before, way).film.mean());
    }
    EXPECT_GT(least, 0.5);
    stress::record("a lamp in the plane of the ceiling",
                   "mean " + std::to_string(least) + " of the clean one, at least 0.5");
}

TEST(StressSurfaces, NeedlesAndSurfacesWithoutArea) {
    const mock::Scene hard = box({matte({{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}),
                                  matte({{0, 0, 0}, {0.5f, 0, 0.5f}, {0.5f, 0, 0.5f}}),
                                  matte({{-0.9f, 0, 0}, {1.8f, 0, 0}, {0, 1e-7f, 1e-7f}}),
                                  matte({{kNan, 0, 0}, {1, 0, 0}, {0, 0, 1}}),
                                  matte({{0, 0, 0}, {kNan, kNan, 0}, {0, 0, 1}})});
    expect_same("quads of no area, 1e-7 wide, and of NaN", {&hard}, box({}));
}

/// Matte surfaces scatter alike on both sides, so that it must not matter which is the front.
TEST(StressSurfaces, TurnedFronts) {
    mock::Scene hard;
    for (const mock::Quad& q : {mock::Quad{{-1, -1, -1}, {0, 2, 0}, {2, 0, 0}},
                                mock::Quad{{-1, -1, -1}, {0, 0, 2}, {0, 2, 0}},
                                mock::Quad{{-1, -1, -1}, {2, 0, 0}, {0, 0, 2}},
                                mock::Quad{{1, 1, 1}, {-2, 0, 0}, {0, -2, 0}},
                                mock::Quad{{1, 1, 1}, {0, -2, 0}, {0, 0, -2}},
                                mock::Quad{{1, 1, 1}, {0, 0, -2}, {-2, 0, 0}}})
        hard.add(matte(q));
    hard.add(lamp(0.98f));
    hard.finish();
    expect_same("a box inside out", {&hard}, box({}));
}

/// Shading normals that a host must not give: none, or on the other side of the surface.
TEST(StressSurfaces, NoNormalAndNormalsOfTheOtherSide) {
    mock::Surface sheet = matte({{-0.5f, 0.3f, -0.8f}, {1, 0, 0}, {0, 0, 1}});  // normal -y
    const mock::Scene clean = box({sheet});
    for (const Way& way : ways()) {
        const double expected = render(clean, way).film.mean();
        sheet.normal_tilt = {0, 2, 0};
        const auto turned = render(box({sheet}), way);
        EXPECT_NEAR(turned.film.mean(), expected, 0.2 * expected);
        sheet.normal_tilt = {0, 1, 0};
        const auto none = render(box({sheet}), way);
        EXPECT_NEAR(none.film.mean(), expected, 0.4 * expected);
        ASSERT_EQ(none.statistics.refused.size(), 1u);
        EXPECT_EQ(none.statistics.refused.front().first, R"(material "surface 7")");
    }
    stress::record("shading normals turned round, and of no length", "refused by material");
}

/// A long floor lit and seen at about a ten-thousandth of a radian.
TEST(StressSurfaces, GrazingLightAndViews) {
    mock::Scene scene;
    scene.add(matte({{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}));
    mock::Surface strip = lamp(0);
    strip.shape = mock::Quad{{-1, 1, 1e-4f}, {0, 0, 1e-3f}, {2, 0, 0}};
    strip.emitted = {1000, 1000, 1000};
    scene.add(strip);
    scene.finish();
    const mock::Camera camera({0, -0.999f, 1e-4f}, {0, 1, 0}, {0.5f, 0, 0}, {0, 0, -1e-3f}, kWidth,
                              kHeight);
    for (const Way& way : ways()) {
        for (const bool direct : {true, false}) {
            Settings settings = settings_for(way);
            settings.direct_light_sampling = direct;
            const auto r = mock::render(scene, camera, kWidth, kHeight, settings, 4);
            EXPECT_TRUE(r.statistics.refused.empty());
            for (const Rgb& pixel : r.film.image()) {
                ASSERT_TRUE(is_valid_radiance(pixel));
                EXPECT_LE(pixel.r, 1000) << "brighter than the lamp";
            }
        }
    }
    stress::record("floor lit and seen at 1e-4 radians", "no pixel above the lamp");
}

mock::Surface ball(Vec3 center, float radius, Kind kind, float reflectance = 1) {
    mock::Surface surface;
    surface.shape = mock::Ball{center, radius, false};
    surface.material.kind = kind;
    surface.material.reflectance = {reflectance, reflectance, reflectance};
    return surface;
}

mock::Surface inside_out(mock::Surface surface) {
    std::get<mock::Ball>(surface.shape).inside_out = true;
    return surface;
}

/// Under a sky of radiance 1 everything that absorbs nothing shows 1, whatever it is nested in and
/// whichever way round: what enters glass more dense by the squared index leaves less dense again.
TEST(StressSurfaces, GlassInsideOutNestedAndOverlapping) {
    const std::vector<std::pair<std::string, std::vector<mock::Surface>>> cases{
        {"inside out", {inside_out(ball({0, 0, 0}, 0.5f, Kind::Glass))}},
        {"nested", {ball({0, 0, 0}, 0.5f, Kind::Glass), ball({0, 0, 0}, 0.4f, Kind::Glass)}},
        {"nested, the inner inside out",
         {ball({0, 0, 0}, 0.5f, Kind::Glass), inside_out(ball({0, 0, 0}, 0.4f, Kind::Glass))}},
        {"coincident", {ball({0, 0, 0}, 0.5f, Kind::Glass), ball({0, 0, 0}, 0.5f, Kind::Glass)}},
        {"overlapping",
         {ball({-0.2f, 0, 0}, 0.4f, Kind::Glass), ball({0.2f, 0, 0}, 0.4f, Kind::Glass)}},
        {"white in glass",
         {ball({0, 0, 0}, 0.5f, Kind::Glass), ball({0.05f, 0, 0}, 0.3f, Kind::Lambert)}},
        {"glass on white",
         {ball({0, 0, -0.3f}, 0.2f, Kind::Glass), ball({0, 0, 0.2f}, 0.3f, Kind::Lambert)}}};
    double worst = 0;
    for (const auto& [what, surfaces] : cases) {
        mock::Scene scene;
        for (const mock::Surface& surface : surfaces)
            scene.add(surface);
        scene.add_environment({1, 1, 1});
        scene.finish();
        const auto camera = mock::camera_along_y({0, -2, 0}, 0.25f, kWidth, kHeight);
        for (const Way& way : ways()) {
            Settings settings = settings_for(way);
            settings.photons_per_pass = 20000;
            settings.max_eye_depth = settings.max_photon_depth = 200;
            const auto r =
                mock::render(scene, camera, kWidth, kHeight, settings, stress::sized(6, 60));
            EXPECT_TRUE(r.statistics.refused.empty()) << what;
            for (const Rgb& pixel : r.film.image())
                ASSERT_TRUE(is_valid_radiance(pixel));
            // The disc of density estimation reaches over the edges of balls.
            EXPECT_NEAR(r.film.mean(), 1, 0.08)
                << what << ", guide " << mock::name(way.guide) << ", mode " << int(way.mode);
            worst = std::max(worst, std::abs(r.film.mean() - 1));
        }
    }
    stress::record("7 arrangements of glass under a sky of 1",
                   "mean off by " + std::to_string(worst) + " of at most 0.08");
}

/// A scene that says of its bounds what is given.
class MisboundScene final : public aips::Scene {
  public:
    MisboundScene(const mock::Scene& scene, const Bounds& bounds)
        : scene_(scene), bounds_(bounds) {}

    bool intersect(const Ray& ray, SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override {
        return scene_.intersect(ray, point, memory);
    }
    Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const override {
        return scene_.spawn(point, direction, time);
    }
    Rgb visibility(const SurfacePoint& point, const DirectSample& light,
                   float time) const override {
        return scene_.visibility(point, light, time);
    }
    std::span<const Light* const> lights() const override { return scene_.lights(); }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override { return 1; }
    Bounds bounds() const override { return bounds_; }
    SceneFacts facts() const override { return scene_.facts(); }

  private:
    const mock::Scene& scene_;
    Bounds bounds_;
};

/// Bounds only steer: the image must not depend on them.
TEST(StressSurfaces, BoundsThatAreNoBox) {
    const mock::Scene scene = box({});
    const std::vector<Bounds> cases{
        {},
        {{kNan, kNan, kNan}, {kNan, kNan, kNan}},
        {{-kInfinity, -1, -1}, {kInfinity, 1, 1}},
        {{kInfinity, kInfinity, kInfinity}, {kInfinity, kInfinity, kInfinity}},
        {{0.1f, 0.1f, 0.1f}, {0.1f, 0.1f, 0.1f}},
        {{5, 5, 5}, {6, 6, 6}}};
    double worst = 0;
    for (const Way& way : ways()) {
        const double expected = render(scene, way).film.mean();
        for (const Bounds& bounds : cases) {
            const auto r = render(MisboundScene(scene, bounds), way);
            EXPECT_TRUE(r.statistics.refused.empty());
            EXPECT_NEAR(r.film.mean(), expected, 0.05 * expected)
                << "bounds " << bounds.lower.x << " to " << bounds.upper.x << ", guide "
                << mock::name(way.guide) << ", mode " << int(way.mode);
            worst = std::max(worst, std::abs(r.film.mean() / expected - 1));
        }
    }
    stress::record("bounds empty, NaN, infinite, a point, elsewhere",
                   "mean off by " + std::to_string(worst) + " of at most 0.05");
}

/// A limit: one vertex far away makes the radius as wide as 1e-9 of the way there.
TEST(StressSurfaces, RadiusIsNoFinerThanABillionthOfTheScene) {
    const mock::Scene scene = box({});
    const Bounds bounds{{-1e9f, -1e9f, -1e9f}, {1e9f, 1e9f, 1e9f}};
    const auto r = render(MisboundScene(scene, bounds), {});
    EXPECT_NEAR(r.statistics.radius, 1e-9f * bounds.diagonal(), 1e-11f * bounds.diagonal());
    stress::record("a box of 2 in bounds of 2e9",
                   "radius " + std::to_string(r.statistics.radius) + ", 1e-9 of their diagonal");
}

}  // namespace
}  // namespace aips::hard_surfaces_test
