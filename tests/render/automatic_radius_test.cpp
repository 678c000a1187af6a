// Protects the default of "radius": adaptive, but for those who ask for a schedule of their own.
#include <gtest/gtest.h>

#include "rendered_image.h"

namespace automatic_radius_test {
namespace {

class AutomaticRadius : public testing::Test {
  protected:
    std::vector<float> image(const std::string& settings) {
        std::string arguments = "--passes 6 --set aips.photonperpass=20000";
        if (!settings.empty()) arguments += " " + settings;
        return render::render(scene_, arguments, folder_).rgb;
    }
    const render::Folder folder_;
    const std::filesystem::path scene_ = render::small_scene("glass-ball", folder_, 48, 32);
};

TEST_F(AutomaticRadius, AdaptsByDefault) {
    const auto automatic = image("");
    EXPECT_EQ(automatic, image("--set aips.radius=adaptive"));
    EXPECT_NE(automatic, image("--set aips.radius=schedule"));
}

TEST_F(AutomaticRadius, KeepsToAScheduleThatIsAskedFor) {
    for (const std::string own : {"--set aips.startradius=1.5", "--set aips.alpha=1",
                                  "--set aips.guide=paper", "--set aips.mode=photonmap"}) {
        const auto automatic = image(own);
        EXPECT_EQ(automatic, image(own + " --set aips.radius=schedule")) << own;
    }
}

}  // namespace
}  // namespace automatic_radius_test
