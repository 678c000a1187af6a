// Protects: whatever a host's surface or light gives in place of a number, in each mode and with
// each guide, no NaN, infinite or negative value reaches the film; what is refused is counted
// against the surface's material, the light, or what light passes, and against nothing else; and
// the rest of the image is as it would be.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render_mock.h"
#include "spoiled_scene.h"
#include "stress_case.h"

namespace aips::refused_radiance_test {
namespace {

using mock::Part;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kWidth = 16, kHeight = 12;
constexpr std::uint32_t kBall = 6, kLamp = 7;  // surfaces of the scene, after six walls
/// Lights: the point light comes first.
constexpr std::uint32_t kPointLight = 0, kLampLight = 1;

/// A box with a glossy half mirror for a ball, a lamp and a faint point light.
mock::Scene box(mock::Material::Kind ball) {
    mock::Scene scene;
    mock::Surface surface;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    surface.shape = mock::Ball{{0.2f, 0.2f, -0.3f}, 0.6f, false};
    surface.material.kind = ball;
    surface.material.specular = {0.3f, 0.3f, 0.3f};
    surface.material.exponent = 3;
    scene.add(surface);
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-0.9f, -0.9f, 0.98f}, {0, 1.8f, 0}, {1.8f, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {1, 1, 1};
    scene.add(lamp);
    scene.add_point_light({0.7f, -0.7f, 0.7f}, {0.3f, 0.3f, 0.3f});
    scene.finish();
    return scene;
}

/// A ball under a sky that is its only light.
mock::Scene ball_under_sky() {
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Ball{{0, 0.3f, 0}, 0.6f, false};
    scene.add(surface);
    scene.add_environment({1, 1, 1});
    scene.finish();
    return scene;
}

/// How a spoiled scene is rendered, and what its refusals must name.
struct Case {
    Part part;
    std::uint32_t index;
    mock::Material::Kind ball;
    std::string origin;  ///< empty: what is spoiled only steers, and nothing is refused
    bool direct_light = true;
};

constexpr auto kLambert = mock::Material::Kind::Lambert;
constexpr auto kPhong = mock::Material::Kind::Phong;
constexpr auto kPaint = mock::Material::Kind::LambertAndMirror;

std::vector<Case> cases() {
    const std::string ball = R"(material "surface 6")", lamp = "light 1 (spoiled)",
                      point = "light 0 (spoiled)",
                      passage = "media or surfaces that light passes straight";
    return {{Part::BsdfValue, kBall, kPaint, ball},
            {Part::BsdfValue, kBall, kPhong, ball},
            {Part::BsdfPdf, kBall, kPhong, ball},
            {Part::BsdfWeight, kBall, kPaint, ball},
            {Part::BsdfWeight, kBall, kPhong, ball},
            {Part::BsdfAlbedo, kBall, kPaint, ""},
            {Part::BsdfDirection, kBall, kPhong, ball},
            {Part::LambertReflectance, kBall, kLambert, ball},
            {Part::SurfacePosition, kBall, kLambert, ball},
            {Part::SurfaceDistance, kBall, kLambert, ball},
            {Part::GeometricNormal, kBall, kPaint, ball},
            {Part::ShadingNormal, kBall, kPaint, ball},
            {Part::Emitted, kLamp, kPhong, "light 1"},
            {Part::LightPower, kLampLight, kLambert, lamp},
            {Part::LightPower, kPointLight, kLambert, point, false},
            {Part::LightOrigin, kPointLight, kLambert, point},
            {Part::LightDirection, kLampLight, kLambert, lamp},
            {Part::DirectRadiance, kLampLight, kLambert, lamp},
            {Part::DirectPdf, kLampLight, kLambert, lamp},
            {Part::DirectDirection, kLampLight, kPhong, lamp},
            {Part::PdfDirect, kLampLight, kPhong, lamp},
            {Part::EmissionCoordinates, kLampLight, kPaint, ""},
            {Part::LightsOwnPower, kLampLight, kPaint, lamp},
            {Part::Transmittance, 0, kLambert, passage},
            {Part::Visibility, 0, kLambert, passage}};
}

/// A negative or infinite coordinate of a normal or a direction is a number still, though of no
/// unit vector; an infinite density of a direction is one that another strategy always finds.
bool is_refused(Part part, float value) {
    switch (part) {
        case Part::SurfacePosition:
        case Part::SurfaceDistance:
        case Part::GeometricNormal:
        case Part::ShadingNormal:
        case Part::BsdfDirection:
        case Part::LightOrigin:
        case Part::LightDirection:
        case Part::DirectDirection:
            return !std::isfinite(value);
        case Part::PdfDirect:
            return value != kInfinity;
        default:
            return true;
    }
}

Settings settings_for(GuideKind guide, Mode mode) {
    Settings settings = mock::small_settings(17, 3000);
    settings.guide = guide;
    settings.mode = mode;
    settings.max_eye_depth = 6;
    return settings;
}

void expect_refusals(const Case& c, float value, const mock::Rendering& r) {
    const bool refuses = !c.origin.empty() && is_refused(c.part, value);
    EXPECT_EQ(r.statistics.refused.size(), refuses ? 1u : 0u);
    for (const auto& [origin, count] : r.statistics.refused) {
        EXPECT_EQ(origin, c.origin);
        EXPECT_GT(count, 0u);
    }
}

void expect_image(const mock::Rendering& r) {
    for (const Rgb& pixel : r.film.image())
        ASSERT_TRUE(is_valid_radiance(pixel)) << pixel.r << ' ' << pixel.g << ' ' << pixel.b;
    for (const double figure : {r.statistics.emission_gain, r.statistics.survival_gain,
                                r.statistics.bounce_gain, r.statistics.score_times_cost}) {
        EXPECT_TRUE(std::isfinite(figure));
    }
}

/// Returns how many renders it took.
int try_all(GuideKind guide, Mode mode, const mock::Camera& camera) {
    int renders = 0;
    for (const Case& c : cases()) {
        for (const float value : {kNan, kInfinity, -kInfinity, -1.0f}) {
            SCOPED_TRACE(testing::Message() << mock::name(c.part) << " = " << value << ", guide "
                                            << mock::name(guide) << ", mode " << int(mode));
            const mock::Scene scene = box(c.ball);
            Settings settings = settings_for(guide, mode);
            settings.direct_light_sampling = c.direct_light;
            const auto r = mock::render(mock::SpoiledScene(scene, {c.part, c.index, value}), camera,
                                        kWidth, kHeight, settings, stress::sized(2, 12));
            expect_image(r);
            expect_refusals(c, value, r);
            ++renders;
        }
    }
    return renders;
}

TEST(StressRefusedRadiance, EverythingThatAHostGives) {
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    int renders = 0;
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive})
        renders += try_all(guide, Mode::Progressive, camera);
    for (const Mode mode : {Mode::PhotonMap, Mode::Ppm})
        renders += try_all(GuideKind::Adaptive, mode, camera);
    stress::record(
        std::to_string(cases().size()) + " parts of a host as NaN, +-inf, -1, in 5 settings",
        std::to_string(renders) + " renders, each refusal at its origin");
}

TEST(StressRefusedRadiance, SkyThatIsNoNumber) {
    const auto camera = mock::camera_along_y({0, -2, 0}, 0.5f, kWidth, kHeight);
    const mock::Scene scene = ball_under_sky();
    for (const Part part : {Part::Escaped, Part::DirectRadiance, Part::LightPower}) {
        for (const float value : {kNan, kInfinity, -1.0f}) {
            SCOPED_TRACE(testing::Message() << mock::name(part) << " = " << value);
            Settings settings = settings_for(GuideKind::Adaptive, Mode::Progressive);
            settings.direct_light_sampling = part != Part::LightPower;
            const auto r = mock::render(mock::SpoiledScene(scene, {part, 0, value}), camera, kWidth,
                                        kHeight, settings, 2);
            expect_image(r);
            ASSERT_EQ(r.statistics.refused.size(), 1u);
            EXPECT_EQ(r.statistics.refused.front().first, "light 0 (spoiled)");
        }
    }
    stress::record("3 parts of a sky as NaN, inf, -1", "refused by light");
}

/// What is refused is lost, but takes nothing else with it: the image is that of the same scene
/// with a black ball, which absorbs all.
TEST(StressRefusedRadiance, TheRestOfTheImageStays) {
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    mock::Material black;
    black.reflectance = {0, 0, 0};
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        const Settings settings = settings_for(guide, Mode::Progressive);
        const mock::Scene scene = mock::lamp_box({}, {}), absorbing = mock::lamp_box({}, black);
        const auto clean = mock::render(absorbing, camera, kWidth, kHeight, settings, 20);
        const auto spoiled =
            mock::render(mock::SpoiledScene(scene, {Part::LambertReflectance, kBall, kNan}), camera,
                         kWidth, kHeight, settings, 20);
        // Photons still see the healthy shape of the reflectance: only what is seen of the ball is
        // refused, so the walls may be brighter by what it sends them, but never darker.
        EXPECT_GT(spoiled.film.mean(), 0.97 * clean.film.mean()) << mock::name(guide);
        EXPECT_LT(spoiled.film.mean(), 1.25 * clean.film.mean()) << mock::name(guide);
        stress::record(
            "a ball of reflectance NaN against a black one",
            "mean " + std::to_string(spoiled.film.mean() / clean.film.mean()) + " of 0.97 to 1.25");
    }
}

}  // namespace
}  // namespace aips::refused_radiance_test
