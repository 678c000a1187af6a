// Protects where photons are kept: at the visible points of their own pass, which are new in each
// pass or frozen with the first.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::reach_test {
namespace {

/// 64 points whose radii cover some 2 % of the image: were photons kept where the first pass had
/// its points, less than half would be gathered. About 1700 are in each pass.
TEST(Reach, FollowsTheVisiblePointsOfEachPass) {
    constexpr std::uint32_t kWidth = 128, kHeight = 96;
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    for (const Mode mode : {Mode::Progressive, Mode::PhotonMap, Mode::Ppm}) {
        Settings settings = mock::small_settings(31, 200'000);
        settings.mode = mode;
        settings.hit_points_per_pass = 64;
        settings.start_radius = 1;
        settings.direct_light_sampling = false;
        const mock::Sampler sampler(settings.seed);
        mock::Film film(kWidth, kHeight);
        mock::Log log;
        Engine engine({scene, camera, sampler, film, log}, settings);
        engine.render_pass(0);
        const std::uint64_t first = engine.statistics().gathered;
        EXPECT_GT(first, 1000u);
        std::uint64_t before = first;
        for (std::uint64_t pass = 1; pass < 4; ++pass) {
            engine.render_pass(pass);
            const std::uint64_t gathered = engine.statistics().gathered - before;
            EXPECT_NEAR(double(gathered), double(first), 0.4 * double(first))
                << "mode " << int(mode) << " pass " << pass;
            before += gathered;
        }
    }
}

}  // namespace
}  // namespace aips::reach_test
