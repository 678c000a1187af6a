// Protects the absolute scale of light end to end: scenes/furnace.lxs against its closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "rendered_image.h"
#include "test_form.h"

namespace furnace_scene_test {
namespace {

/// Mean of the middle of the image: the view of the far wall, away from the edges of the box.
double middle(const render::Image& image) {
    const auto l = image.luminance();
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t y = image.height * 3 / 8; y < image.height * 5 / 8; ++y) {
        for (std::size_t x = image.width * 3 / 8; x < image.width * 5 / 8; ++x, ++count) {
            sum += l[y * image.width + x];
        }
    }
    return sum / double(count);
}

TEST(FurnaceScene, ClosedFormWithEveryGuideAndMode) {
    const render::Folder folder;
    const auto scene = render::small_scene("furnace", folder, 80, 60);
    const double expected = 2 * (1 - std::pow(0.5, 17));
    // Over seeds the mean has a standard deviation of a third of what is let pass.
    const std::string options = "--passes " + std::to_string(statistics::sized(6, 16)) +
                                " --seed 3 --set aips.photonperpass=100000";
    const double let_pass = statistics::sized(0.016, 0.01);
    for (const char* guide : {"none", "paper", "adaptive"}) {
        for (const char* mode : {"progressive", "photonmap", "ppm"}) {
            const auto image = render::render(
                scene, options + " --set aips.guide=" + guide + " --set aips.mode=" + mode, folder);
            EXPECT_NEAR(middle(image), expected, let_pass * expected) << guide << " " << mode;
        }
    }
}

}  // namespace
}  // namespace furnace_scene_test
