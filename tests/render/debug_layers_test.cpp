// Protects `debuglayers`: the EXR of a whole render has the layers of docs/debug-layers.md, its
// image stays the same, and the photon part is what photons brought.
#include <gtest/gtest.h>

#include <cmath>
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

/// What the filter's negative lobes draw below zero is paid by the light around it, in the image
/// and in its photon part each by itself: sums over the image hold, single pixels only away from
/// there.
TEST(DebugLayers, ImageIsPhotonPartPlusEyePart) {
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, 48, 32);
    const std::string common = "--passes 2 --set aips.photonperpass=20000 --set aips.guide=paper ";
    const auto plain = render::render(scene, common, folder);
    const auto image = render::render(scene, common + "--set aips.debuglayers=true", folder);
    EXPECT_EQ(plain.rgb, image.rgb) << "layers change the image";
    const auto photons = render::read_layer(folder.path() / "out.exr", "photons").rgb;
    const auto eye = render::render(scene, common + "--set aips.maxphotondepth=1", folder);
    std::size_t compared = 0, apart = 0;
    double image_sum = 0, parts_sum = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        image_sum += image.rgb[i];
        parts_sum += double{photons[i]} + eye.rgb[i];
        if (!(photons[i] > 0 && eye.rgb[i] > 0 && image.rgb[i] > 0)) continue;
        ++compared;
        if (std::abs(image.rgb[i] - photons[i] - eye.rgb[i]) > 1e-5f * image.rgb[i]) ++apart;
    }
    EXPECT_NEAR(image_sum, parts_sum, 1e-6 * parts_sum);
    EXPECT_GT(compared, image.rgb.size() / 2);
    EXPECT_LT(apart, compared / 20);
}

}  // namespace
