// Protects: NaN, infinite and negative contributions never reach the film; they are counted under
// the material where they arose.
#include <gtest/gtest.h>

#include <limits>

#include "render_mock.h"

namespace aips::invalid_sample_filter_test {
namespace {

mock::Rendering render_with_reflectance(float value) {
    mock::Material ball;
    ball.reflectance = {value, value, value};
    const mock::Scene scene = mock::lamp_box({}, ball);
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 24, 18);
    return mock::render(scene, camera, 24, 18, mock::small_settings(81, 5000), 2);
}

TEST(InvalidSampleFilter, BadReflectanceIsCountedByMaterialAndKeptOut) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f}) {
        const auto r = render_with_reflectance(bad);
        ASSERT_FALSE(r.statistics.refused.empty()) << bad;
        for (const auto& [origin, count] : r.statistics.refused) {
            EXPECT_EQ(origin, R"(material "surface 6")") << bad;  // the ball, after six walls
            EXPECT_GT(count, 0u);
        }
        for (const Rgb& pixel : r.film.image())
            EXPECT_TRUE(is_valid_radiance(pixel));
    }
}

TEST(InvalidSampleFilter, HealthySceneRefusesNothing) {
    EXPECT_TRUE(render_with_reflectance(0.5f).statistics.refused.empty());
}

}  // namespace
}  // namespace aips::invalid_sample_filter_test
