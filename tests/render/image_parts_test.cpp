// Protects the layers `direct`, `indirect` and `caustics` (docs/reference/layers.md):
// they and the light groups sum to the image, whatever carries the light, and photons and path
// tracing mean the same light by them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "block_test.h"
#include "rendered_image.h"
#include "test_form.h"

namespace image_parts_test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kParts{"direct", "indirect", "caustics"};

/// Expects that layers sum to the image, up to roundings of the brightest.
void expect_sum(const fs::path& file, const std::vector<std::string>& layers,
                const std::string& what) {
    const std::vector<float> image = render::read_image(file).rgb;
    std::vector<double> sum(image.size());
    for (const std::string& layer : layers) {
        const std::vector<float> part = render::read_layer(file, layer).rgb;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            ASSERT_GE(part[i], 0) << what << ": " << layer;
            sum[i] += double{part[i]};
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
        ASSERT_NEAR(image[i], sum[i], 1e-6 * (1e-3 + double{image[i]})) << what << " at " << i;
}

/// The scene in two light groups: its lamps are of the second one, and a point light of the first.
fs::path in_two_groups(const fs::path& scene, const render::Folder& folder) {
    return render::edited_scene(
        scene, folder,
        {{"WorldBegin",
          "WorldBegin\nLightSource \"point\" \"point from\" [0 0 0.5] \"color L\" [1 2 3]\n"
          "LightGroup \"lamps\"\n"}});
}

TEST(ImageParts, SumToTheImageWhateverCarriesTheLight) {
    const render::Folder folder;
    const auto scene = in_two_groups(render::small_scene("glass-ball", folder, 36, 24), folder);
    const std::string few = ".photonperpass=20000";
    const std::vector<std::string> ways{"aips",
                                        "aips --set aips.guide=none",
                                        "aips --set aips.continueeyepaths=false",
                                        "aips --set aips.guidelamps=false",
                                        "aips --set aips.directlightsampling=false",
                                        "aips --set aips.storeglossy=true",
                                        "path",
                                        "sppm --set sppm" + few,
                                        "ppm --set ppm" + few,
                                        "exphotonmap --set exphotonmap" + few};
    for (const std::string& way : ways) {
        const std::string common = "--passes 6 --quiet --integrator " + way;
        const auto plain = render::render(scene, common, folder);
        const auto with = render::render(scene, common + " --layers all", folder);
        EXPECT_EQ(plain.rgb, with.rgb) << way << ": layers change the image";
        expect_sum(folder.path() / "out.exr", kParts, way);
        expect_sum(folder.path() / "out.exr", {"default", "lamps"}, way);
    }
}

/// Box filters have no lobes below zero, and these primaries are those of the scene: nothing is to
/// be settled. (The film's usual ones and the usual filter are in all other tests here.)
TEST(ImageParts, SumToTheImageWithoutSettlingAnything) {
    const render::Folder folder;
    const auto scene =
        render::edited_scene(render::small_scene("glass-ball", folder, 36, 24), folder,
                             {{"PixelFilter \"mitchell\"", "PixelFilter \"box\""}});
    render::render(scene, "--passes 3 --quiet --layers all", folder);
    expect_sum(folder.path() / "out.exr", kParts, "box");
}

TEST(ImageParts, SumToTheImageInMediaAndByWavelengths) {
    const render::Folder folder;
    const auto scene = render::small_scene("prism", folder, 36, 24);
    for (const std::string way : {"aips", "path"}) {
        render::render(scene, "--passes 4 --quiet --layers all --integrator " + way, folder);
        expect_sum(folder.path() / "out.exr", kParts, way);
    }
}

/// Many short renders tell more than few long ones of as many passes.
unsigned renders() {
    return statistics::sized(12u, 6u);
}
constexpr int kSize = 32;

/// [layer][seed][block]
std::vector<statistics::BlockMeans> parts_by(const std::string& way) {
    const render::Folder folder;
    const auto scene = render::small_scene("cornell-box", folder, kSize, kSize);
    std::vector<statistics::BlockMeans> means(kParts.size());
    const unsigned seeds = renders();
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        render::render(scene,
                       "--quiet --layers direct,indirect,caustics --seed " + std::to_string(seed) +
                           " --integrator " + way,
                       folder);
        for (std::size_t part = 0; part < kParts.size(); ++part)
            means[part].push_back(
                render::read_layer(folder.path() / "out.exr", kParts[part]).block_means(kSize / 2));
    }
    return means;
}

/// The bias of the radius may be some percent in a block, where the image's borders are.
TEST(ImageParts, AreTheSameLightByPhotonsAndByPaths) {
    constexpr double kSignificance = 1e-5, kAllowed = 0.05;
    const auto paths = parts_by("path --passes " + std::to_string(statistics::sized(30, 100)));
    for (const std::string way : {"aips", "exphotonmap --set exphotonmap.photonperpass=100000"}) {
        const auto photons =
            parts_by(way + " --passes " + std::to_string(statistics::sized(4, 12)));
        for (std::size_t part = 0; part < kParts.size(); ++part) {
            const auto comparison =
                statistics::compare(paths[part], photons[part], kSignificance, kAllowed);
            EXPECT_FALSE(comparison.differs())
                << way << ", " << kParts[part] << ": " << comparison.describe();
            // Twice as much would be found, and the light of any other part in its place.
            EXPECT_LT(comparison.detectable, 1) << way << ", " << kParts[part];
        }
    }
}

}  // namespace
}  // namespace image_parts_test
