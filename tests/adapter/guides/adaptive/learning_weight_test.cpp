// Protects the weights of what is shot while a guide learns: fixed in advance, never zero, and full
// in the end.
#include "guides/adaptive/learning_weight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "render_mock.h"

namespace aips::learning_weight_test {
namespace {

TEST(LearningWeight, GrowsToOneAndStays) {
    EXPECT_EQ(learning_weight(0), kFirstWeight);
    double last = 0;
    for (std::uint64_t paths = 0; paths < 2'000'000; paths += 16384) {
        const double weight = learning_weight(paths);
        EXPECT_GE(weight, last);
        last = weight;
    }
    EXPECT_EQ(last, 1);
    EXPECT_EQ(learning_weight(std::uint64_t{1} << 60), 1);
}

// A pass counts in the photons' part of the image by its photon paths as they weigh, all of them
// without a guide.
TEST(LearningWeight, PassesCountByTheirPaths) {
    constexpr std::uint32_t kPaths = 40000, kIteration = 16384;
    const mock::Scene scene = mock::lamp_box({}, {});
    const mock::Camera camera = mock::camera_along_y({0, -0.95f, 0}, 1, 8, 8);
    Settings settings = mock::small_settings(1, kPaths);
    EXPECT_EQ(mock::render(scene, camera, 8, 8, settings, 2).film.photon_weights(),
              std::vector<double>(2, kPaths));
    settings.guide = GuideKind::Adaptive;
    std::vector<double> expected(2, 0.0);
    for (unsigned pass = 0; pass < 2; ++pass) {
        for (std::uint32_t first = 0; first < kPaths; first += kIteration) {
            expected[pass] +=
                learning_weight(pass * kPaths + first) * std::min(kIteration, kPaths - first);
        }
    }
    EXPECT_LT(expected[0], 0.02 * kPaths);
    EXPECT_EQ(mock::render(scene, camera, 8, 8, settings, 2).film.photon_weights(), expected);
    // Whatever the eye saw: these look out into the dark.
    const mock::Camera away = mock::camera_along_y({0, 5, 0}, 1, 8, 8);
    const auto dark = mock::render(scene, away, 8, 8, settings, 2);
    EXPECT_EQ(dark.film.mean(), 0);
    EXPECT_EQ(dark.film.photon_weights(), expected);
}

// Eye paths know nothing of a guide: those of learning passes count in full.
TEST(LearningWeight, EyePathsOfAllPassesCountAlike) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const mock::Camera camera = mock::camera_along_y({0, -0.95f, 0}, 1, 8, 8);
    Settings settings = mock::small_settings(1, 40000);
    const auto unguided = mock::render(scene, camera, 8, 8, settings, 3);
    settings.guide = GuideKind::Adaptive;
    const auto guided = mock::render(scene, camera, 8, 8, settings, 3);
    EXPECT_NE(guided.film.photon_weights()[0], unguided.film.photon_weights()[0]);
    EXPECT_EQ(guided.film.eye_part(), unguided.film.eye_part());
    EXPECT_GT(luminance(guided.film.eye_part()[0]), 0);
}

}  // namespace
}  // namespace aips::learning_weight_test
