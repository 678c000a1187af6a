// Protects: one moment of the shutter interval per pass, for eye, shadow and photon rays alike, and
// different moments for different passes, unless their visible points are frozen.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "render_mock.h"

namespace time_test {
namespace {

/// The moments at which rays are traced in `passes` passes.
std::set<float> times_of(aips::Mode mode, std::uint32_t passes) {
    mock::Scene scene = mock::lamp_box({}, {});
    std::mutex mutex;
    std::set<float> times;
    scene.on_ray = [&](float time) {
        const std::scoped_lock lock(mutex);
        times.insert(time);
    };
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 8, 8);
    aips::Settings settings = mock::small_settings(51, 500);
    settings.mode = mode;
    mock::render(scene, camera, 8, 8, settings, passes);
    for (const float time : times) {
        EXPECT_GE(time, camera.shutter_open());
        EXPECT_LT(time, camera.shutter_close());
    }
    return times;
}

TEST(Time, OnePerPassForAllRays) {
    EXPECT_EQ(times_of(aips::Mode::Progressive, 5).size(), 5u);
}

/// Photons must meet moving surfaces where the frozen eye pass saw them.
TEST(Time, OneForAllPassesOntoFrozenVisiblePoints) {
    EXPECT_EQ(times_of(aips::Mode::PhotonMap, 5).size(), 1u);
    EXPECT_EQ(times_of(aips::Mode::Ppm, 5).size(), 1u);
}

}  // namespace
}  // namespace time_test
