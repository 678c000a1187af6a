// Protects agreement with LuxRender itself: its Cornell scene, rendered by `aips` and by `path`,
// against its own bidirectional result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

#include "rendered_image.h"
#include "test_form.h"

namespace cornell_reference_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(LUX_SCENES) / "cornell_box";
constexpr std::size_t kBlock = 25;

/// Relative differences of block means, blocks that see the lamp left out.
struct Agreement {
    double signed_mean = 0, median = 0, ninetieth = 0;
};

Agreement compare(const render::Image& ours, const render::Image& theirs) {
    const auto a = ours.block_means(kBlock);
    const auto b = theirs.block_means(kBlock);
    const auto brightest = [&](std::size_t block) {
        const auto luminance = theirs.luminance();
        const std::size_t columns = theirs.width / kBlock;
        double most = 0;
        for (std::size_t y = 0; y < kBlock; ++y) {
            for (std::size_t x = 0; x < kBlock; ++x) {
                most = std::max(most, luminance[(block / columns * kBlock + y) * theirs.width +
                                                block % columns * kBlock + x]);
            }
        }
        return most;
    };
    const auto luminance = theirs.luminance();
    const double lamp = 0.5 * *std::max_element(luminance.begin(), luminance.end());
    std::vector<double> differences;
    double sum_a = 0, sum_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (brightest(i) > lamp) continue;
        differences.push_back(std::abs(a[i] / b[i] - 1));
        sum_a += a[i];
        sum_b += b[i];
    }
    std::sort(differences.begin(), differences.end());
    return {sum_a / sum_b - 1, differences[differences.size() / 2],
            differences[differences.size() * 9 / 10]};
}

void check(const std::string& integrator, const std::string& arguments) {
    if (!fs::exists(kFolder)) GTEST_SKIP() << "no LuxRender scenes beside the project";
    const render::Folder folder;
    const auto image = render::render(kFolder / "reference-250.lxs",
                                      "--integrator " + integrator + " " + arguments, folder);
    const Agreement found = compare(image, render::read_image(kFolder / "reference-250.exr"));
    std::cout << integrator << ": signed mean " << 100 * found.signed_mean << " %, median "
              << 100 * found.median << " %, 90th percentile " << 100 * found.ninetieth << " %\n";
    EXPECT_LT(std::abs(found.signed_mean), 0.015);
    EXPECT_LT(found.median, 0.04);
    EXPECT_LT(found.ninetieth, 0.08);
}

/// Of photons.
std::string passes() {
    return "--passes " + std::to_string(statistics::sized(5, 10));
}

TEST(CornellReference, Aips) {
    check("aips", passes() +
                      " --seed 1 --set aips.maxphotondepth=24 --set aips.maxeyedepth=24 "
                      "--set aips.photonperpass=300000");
}

TEST(CornellReference, AipsUnguided) {
    check("aips", passes() +
                      " --seed 2 --set aips.maxphotondepth=24 --set aips.maxeyedepth=24 "
                      "--set aips.photonperpass=500000 --set aips.guide=none");
}

TEST(CornellReference, Path) {
    check("path", "--passes 100 --set path.maxdepth=24 --seed 3");
}

/// The scene made for LuxRender's own sppm renders when only the plugins' names are changed.
TEST(CornellReference, SppmSceneWithNamesChanged) {
    if (!fs::exists(kFolder)) GTEST_SKIP() << "no LuxRender scenes beside the project";
    const render::Folder folder;
    fs::copy(kFolder / "cornell_box", folder.path() / "cornell_box", fs::copy_options::recursive);
    const auto scene =
        render::edited_scene(kFolder / "sppm.lxs", folder,
                             {{"Renderer \"sppm\"", "Renderer \"aips\""},
                              {"SurfaceIntegrator \"sppm\"", "SurfaceIntegrator \"aips\""}});
    const auto image = render::render(scene, "--passes 1 --set aips.photonperpass=100000", folder);
    EXPECT_EQ(image.width, 500u);
    const auto l = image.luminance();
    EXPECT_GT(std::accumulate(l.begin(), l.end(), 0.0), 0);
}

}  // namespace
}  // namespace cornell_reference_test
