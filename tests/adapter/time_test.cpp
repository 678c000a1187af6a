// Protects: one moment of the shutter interval per pass, for eye, shadow and photon rays alike, and
// different moments for different passes.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "render_mock.h"

namespace {

TEST(Time, OnePerPassForAllRays) {
    mock::Scene scene = mock::lamp_box({}, {});
    std::mutex mutex;
    std::set<float> times;
    scene.on_ray = [&](float time) {
        const std::scoped_lock lock(mutex);
        times.insert(time);
    };
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 8, 8);
    constexpr std::uint32_t kPasses = 5;
    mock::render(scene, camera, 8, 8, mock::small_settings(51, 500), kPasses);
    EXPECT_EQ(times.size(), kPasses);
    for (const float time : times) {
        EXPECT_GE(time, camera.shutter_open());
        EXPECT_LT(time, camera.shutter_close());
    }
}

}  // namespace
