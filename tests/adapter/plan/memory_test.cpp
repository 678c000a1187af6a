// Protects: memory is bounded by parameters, the bound is stated at the start, and passes do not
// make it grow.
#include <gtest/gtest.h>

#include <tuple>

#include "flat_memory.h"
#include "render_mock.h"

namespace aips::memory_test {
namespace {

class Memory : public testing::TestWithParam<std::tuple<GuideKind, Mode>> {};

TEST_P(Memory, StaysBelowTheBoundAndFlat) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 32, 24);
    Settings settings = mock::small_settings(71, 20000);
    settings.guide = std::get<0>(GetParam());
    settings.mode = std::get<1>(GetParam());
    settings.alpha = 0.7;
    settings.max_nodes = 512;
    // The adaptive guide sends ever more photons where they land until it has learned, after a
    // million and a half of them; from a million on its iterations are longer.
    const unsigned settled = settings.guide == GuideKind::Adaptive ? 76 : 6;
    const auto late = mock::expect_flat_memory(scene, camera, 32, 24, settings, settled);
    if (settings.guide == GuideKind::Paper) {
        EXPECT_LE(late.guide_nodes, settings.max_nodes);
    }
}

INSTANTIATE_TEST_SUITE_P(
    GuidesAndModes, Memory,
    testing::Combine(testing::Values(GuideKind::None, GuideKind::Paper, GuideKind::Adaptive),
                     testing::Values(Mode::Progressive, Mode::PhotonMap, Mode::Ppm)));

TEST(MemoryOfScores, StaysBelowTheBoundAndFlatWithTheImagesError) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 32, 24);
    Settings settings = mock::small_settings(73, 20000);
    settings.guide = GuideKind::Paper;
    settings.error_criterion = CriterionKind::Image;
    settings.max_nodes = 512;
    mock::expect_flat_memory(scene, camera, 32, 24, settings, 6);
}

/// Photons of a pass wait in memory until about a million are gathered at once, however many
/// there are.
TEST(MemoryOfAPass, DoesNotGrowWithItsPhotons) {
    for (const bool fog : {false, true}) {
        mock::Scene scene = mock::lamp_box({}, {});
        if (fog) scene.fill({{0.2f, 0.2f, 0.2f}, {1, 1, 1}, 0});
        const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 4, 3);
        Settings settings = mock::small_settings(72, 4'000'000);
        settings.max_photon_depth = 2;  // so that what waits is most of the bound
        const mock::Rendering rendering = mock::render(scene, camera, 4, 3, settings, 1);
        EXPECT_LE(rendering.statistics.memory_bytes, rendering.statistics.memory_bound_bytes)
            << (fog ? "with fog" : "without fog");
    }
}

}  // namespace
}  // namespace aips::memory_test
