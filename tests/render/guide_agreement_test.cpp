// Protects: guide=none and guide=paper have the same expectation on real scenes, at the same
// radius schedule.
#include <gtest/gtest.h>

#include <iostream>

#include "block_test.h"
#include "rendered_image.h"

namespace {

constexpr int kWidth = 96, kHeight = 64;

statistics::BlockMeans renders(const std::filesystem::path& scene, const std::string& guide,
                               unsigned first_seed, const render::Folder& folder) {
    statistics::BlockMeans means;
    for (unsigned seed = first_seed; seed < first_seed + 10; ++seed) {
        const auto image = render::render(
            scene,
            "--passes 6 --set aips.photonperpass=30000 --set aips.startradius=3 --set aips.guide=" +
                guide + " --seed " + std::to_string(seed),
            folder);
        means.push_back(statistics::block_means(image.luminance(), kWidth, kHeight, 16));
    }
    return means;
}

/// 25 tests a scene at a family-wise significance of 1 %, fixed seeds.
void check(const std::string& name) {
    const render::Folder folder;
    const auto scene = render::small_scene(name, folder, kWidth, kHeight);
    const auto plain = renders(scene, "none", 100, folder);
    auto guided = renders(scene, "paper", 200, folder);
    const auto same = statistics::compare(plain, guided, 0.01);
    std::cout << name << ": " << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    for (auto& seed : guided) {
        for (double& block : seed)
            block *= 1.02;
    }
    const auto biased = statistics::compare(plain, guided, 0.01);
    EXPECT_TRUE(biased.differs()) << "a planted bias of 2 % went unnoticed: " << biased.describe();
}

TEST(GuideAgreement, GlassBall) {
    check("glass-ball");
}
TEST(GuideAgreement, CornellBox) {
    check("cornell-box");
}

}  // namespace
