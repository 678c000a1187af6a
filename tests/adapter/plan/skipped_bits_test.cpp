// Protects: what a scene has but no light meets changes no bit of the image, nor does leaving out
// what such a scene does not need.
#include <gtest/gtest.h>

#include "eye/eye_pass.h"
#include "render_mock.h"

namespace aips::skipped_bits_test {
namespace {

constexpr std::uint32_t kWidth = 16, kHeight = 12;

/// What is put into lamp_box before it is finished.
using Extra = void (*)(mock::Scene&);

void nothing(mock::Scene&) {}
void dead_lights(mock::Scene& scene) {
    scene.add_point_light({0.5f, 0, 0.5f}, {0, 0, 0});
    scene.add_point_light({-0.5f, 0, 0.5f}, {0, 0, 0});
}
/// Inside of the matte ball on the floor, where neither light nor eye goes.
void hidden(mock::Scene& scene, mock::Material::Kind kind) {
    mock::Surface ball;
    ball.shape = mock::Ball{{0.35f, 0.3f, -0.6f}, 0.2f, false};
    ball.material.kind = kind;
    scene.add(ball);
}
void hidden_mirror(mock::Scene& scene) {
    hidden(scene, mock::Material::Kind::Mirror);
}
void hidden_gloss(mock::Scene& scene) {
    hidden(scene, mock::Material::Kind::Phong);
}

mock::Scene box_with(Extra extra) {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    mock::Surface matte;
    matte.shape = mock::Ball{{0.35f, 0.3f, -0.6f}, 0.4f, false};
    scene.add(matte);
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    extra(scene);
    scene.finish();
    return scene;
}

std::vector<Rgb> image_of(const mock::Scene& scene, const Settings& settings) {
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    return mock::render(scene, camera, kWidth, kHeight, settings, 4).film.image();
}

class UnmetParts : public testing::TestWithParam<GuideKind> {};

TEST_P(UnmetParts, ChangeNoBits) {
    Settings settings = mock::small_settings(91, 20000);
    settings.guide = GetParam();
    const auto plain = image_of(box_with(nothing), settings);
    EXPECT_EQ(image_of(box_with(dead_lights), settings), plain) << "dead lights";
    EXPECT_EQ(image_of(box_with(hidden_mirror), settings), plain) << "a mirror";
    EXPECT_EQ(image_of(box_with(hidden_gloss), settings), plain) << "a glossy ball";
    settings.seed = 92;
    EXPECT_NE(image_of(box_with(nothing), settings), plain);
}

INSTANTIATE_TEST_SUITE_P(Guides, UnmetParts,
                         testing::Values(GuideKind::None, GuideKind::Paper, GuideKind::Adaptive));

/// Where no photon bounces, guide=paper and the parts of guide=adaptive that steer bounces have no
/// say: with and without them the bits are the same.
TEST(SkippedGuides, ChangeNoBits) {
    Settings settings = mock::small_settings(93, 20000);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 1;
    const mock::Scene scene = box_with(nothing);
    const auto unguided = image_of(scene, settings);
    settings.guide = GuideKind::Paper;
    EXPECT_EQ(image_of(scene, settings), unguided);
    settings.guide = GuideKind::Adaptive;
    settings.guide_survival = settings.guide_bounces = false;
    const auto emission_alone = image_of(scene, settings);
    settings.guide_survival = settings.guide_bounces = true;
    EXPECT_EQ(image_of(scene, settings), emission_alone);
}

/// Visible points that no photon will reach are left out: the eye's part of the image stays.
TEST(SkippedVisiblePoints, ChangeNoBits) {
    const mock::View view = mock::half_mirror_view(kWidth, kHeight);
    const Settings settings = mock::small_settings(94, 1);
    const mock::Sampler sampler(settings.seed);
    const DirectLight direct(view.scene, false);
    InvalidSampleFilter filter(view.scene);
    EyePassInput input{view.scene, view.camera, sampler, direct,
                       settings,   kWidth,      kHeight, 16 * kWidth * kHeight};
    EyeImage all, without;
    trace_eye_pass(input, 0, 0, filter, all);
    input.keep_visible_points = false;
    trace_eye_pass(input, 0, 0, filter, without);
    EXPECT_GT(all.visible_points.size(), 0.9 * input.paths);
    EXPECT_TRUE(without.visible_points.empty());
    EXPECT_EQ(without.radiance, all.radiance);
    EXPECT_EQ(without.rays, all.rays);
    EXPECT_LE(without.memory_bytes() + input.paths * sizeof(VisiblePoint), all.memory_bytes());
}

}  // namespace
}  // namespace aips::skipped_bits_test
