// Protects `debuglayers`: the EXR of a whole render has the layers of docs/debug-layers.md, its
// image stays the same, and the photon part is what photons brought.
#include <gtest/gtest.h>

#include <set>

#include "rendered_image.h"

namespace {

const std::set<std::string> kUnguided{
    "R", "G", "B", "photons.R", "photons.G", "photons.B", "photondensity.Y"};

std::set<std::string> guided() {
    std::set<std::string> names = kUnguided;
    names.insert({"nodeerror.Y", "nodeweight.Y", "nodeedges.Y", "guidedshare.Y"});
    return names;
}

TEST(DebugLayers, AreNamedAsDocumented) {
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, 48, 32);
    const auto channels = [&](const std::string& plugin, const std::string& more) {
        render::render(scene,
                       "--passes 2 --integrator " + plugin + " --set " + plugin +
                           ".photonperpass=10000 " + more,
                       folder);
        return render::channel_names(folder.path() / "out.exr");
    };
    EXPECT_EQ(channels("aips", "--set aips.debuglayers=true --set aips.guide=paper"), guided());
    EXPECT_EQ(channels("aips", "--set aips.debuglayers=true --set aips.guide=none"), kUnguided);
    EXPECT_EQ(channels("sppm", "--set sppm.debuglayers=true"), kUnguided);
    EXPECT_EQ(channels("exphotonmap", "--set exphotonmap.debuglayers=true"), kUnguided);
    EXPECT_EQ(channels("aips", ""), (std::set<std::string>{"R", "G", "B"}));
}

/// The film cuts negative values, which the scene's filter makes beside bright edges: where it did,
/// the sum need not hold.
TEST(DebugLayers, ImageIsPhotonPartPlusEyePart) {
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, 48, 32);
    const std::string common = "--passes 2 --set aips.photonperpass=20000 --set aips.guide=paper ";
    const auto plain = render::render(scene, common, folder);
    const auto image = render::render(scene, common + "--set aips.debuglayers=true", folder);
    EXPECT_EQ(plain.rgb, image.rgb) << "layers change the image";
    const auto photons = render::read_layer(folder.path() / "out.exr", "photons").rgb;
    const auto eye = render::render(scene, common + "--set aips.maxphotondepth=1", folder);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        if (!(photons[i] > 0 && eye.rgb[i] > 0 && image.rgb[i] > 0)) continue;
        EXPECT_NEAR(image.rgb[i] - photons[i], eye.rgb[i], 1e-5f * image.rgb[i]) << i;
        ++compared;
    }
    EXPECT_GT(compared, image.rgb.size() / 2);
}

}  // namespace
