// Protects photonsampler=amc in whole renders: the expectation of the plain sampler, the same bits
// for any number of threads, and what a scene is told that asks for it under a guide.
#include <gtest/gtest.h>

#include <iostream>

#include "seeded_renders.h"
#include "test_form.h"

namespace photon_sampler_test {
namespace {

constexpr int kWidth = 96, kHeight = 64;

const std::string kChains = " --set aips.guide=none --set aips.photonsampler=amc";
const std::string kSequence = " --set aips.guide=none --set aips.photonsampler=sobol";

statistics::BlockMeans renders(const std::filesystem::path& scene, const std::string& sampler,
                               unsigned first_seed, const render::Folder& folder) {
    return render::seeded_block_means(
        scene, "--passes 6 --set aips.photonperpass=30000 --set aips.startradius=1.5" + sampler,
        folder, {.first = first_seed, .count = statistics::sized(7u, 10u)}, 16);
}

/// 25 tests at a family-wise significance of 1 %, fixed seeds.
TEST(PhotonSampler, ChainsHaveTheExpectationOfTheSequence) {
    const render::Folder folder;
    const auto scene = render::small_scene("cornell-box", folder, kWidth, kHeight);
    const auto plain = renders(scene, kSequence, 100, folder);
    const auto chains = renders(scene, kChains, 200, folder);
    const auto same = statistics::compare(plain, chains, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    const double planted = statistics::sized(0.03, 0.02);
    EXPECT_LT(same.detectable, planted / 2) << same.describe();
    EXPECT_TRUE(statistics::compare(plain, statistics::scaled(chains, 1 + planted), 0.01).differs())
        << "a planted bias went unnoticed";
}

TEST(PhotonSampler, SameExrWithOneTwoAndSevenThreads) {
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, 120, 80);
    const std::string arguments = "--passes 3 --seed 5 --set aips.photonperpass=40000" + kChains;
    const auto one = render::render(scene, arguments + " --threads 1", folder);
    EXPECT_EQ(one.rgb, render::render(scene, arguments + " --threads 2", folder).rgb);
    EXPECT_EQ(one.rgb, render::render(scene, arguments + " --threads 7", folder).rgb);
}

/// LuxRender's scenes for sppm may ask for amc; renamed to aips they render, and say what is lost.
TEST(PhotonSampler, UnderAGuideIsIgnoredWithALocatedWarning) {
    const render::Folder folder;
    const auto small = render::small_scene("cornell-box", folder, 16, 16);
    const auto scene =
        render::edited_scene(small, folder,
                             {{"SurfaceIntegrator \"aips\"",
                               "SurfaceIntegrator \"aips\" \"string photonsampler\" [\"amc\"]"}});
    const std::string said = render::output_of(
        "cd '" + folder.path().string() + "' && " + LXSRENDER + " --quiet --passes 1 '" +
        scene.string() + "' --set aips.guide=paper --set aips.photonperpass=1000 2>&1");
    EXPECT_NE(said.find("warning: photonsampler \"amc\" is ignored"), std::string::npos) << said;
    EXPECT_NE(said.find(scene.filename().string() + ":"), std::string::npos) << said;
}

}  // namespace
}  // namespace photon_sampler_test
