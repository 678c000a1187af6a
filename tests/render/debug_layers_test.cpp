// Protects `debuglayers`: the EXR of a whole render has the layers of docs/reference/layers.md, its
// image stays the same, and the photon part is what photons brought.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "rendered_image.h"

namespace debug_layers_test {
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

struct Parts {
    std::vector<float> image, photons, eye;
};

/// The image and what it is made of. Expects that layers leave the image as it is.
Parts parts_of_glass_ball(const std::string& filter) {
    const render::Folder folder;
    const auto scene = render::edited_scene(render::small_scene("glass-ball", folder, 48, 32),
                                            folder, {{"PixelFilter \"mitchell\"", filter}});
    const std::string common = "--passes 2 --set aips.photonperpass=20000 --set aips.guide=paper ";
    const auto plain = render::render(scene, common, folder);
    Parts parts;
    parts.image = render::render(scene, common + "--set aips.debuglayers=true", folder).rgb;
    EXPECT_EQ(plain.rgb, parts.image) << "layers change the image";
    parts.photons = render::read_layer(folder.path() / "out.exr", "photons").rgb;
    parts.eye = render::render(scene, common + "--set aips.maxphotondepth=1", folder).rgb;
    return parts;
}

/// But for colours beyond the film's primaries, which move to their border as a whole.
TEST(DebugLayers, ImageIsPhotonPartPlusEyePart) {
    const Parts parts = parts_of_glass_ball("PixelFilter \"box\"");
    std::size_t compared = 0, apart = 0;
    for (std::size_t i = 0; i < parts.image.size(); ++i) {
        const float image = parts.image[i], photons = parts.photons[i], eye = parts.eye[i];
        if (!(photons > 0 && eye > 0)) continue;
        ++compared;
        if (std::abs(image - photons - eye) > 1e-5f * image) ++apart;
    }
    EXPECT_GT(compared, parts.image.size() / 2);
    EXPECT_LT(apart, compared / 20);
}

/// What the filter's negative lobes draw below zero is paid by the light around it, in the image
/// and in its photon part each by itself: sums over the image hold.
TEST(DebugLayers, PartsSumToTheImageWhateverTheFiltersLobes) {
    const Parts parts = parts_of_glass_ball("PixelFilter \"mitchell\"");
    double image = 0, sum = 0;
    for (std::size_t i = 0; i < parts.image.size(); ++i) {
        image += parts.image[i];
        sum += double{parts.photons[i]} + parts.eye[i];
    }
    EXPECT_NEAR(image, sum, 1e-6 * sum);
}

}  // namespace
}  // namespace debug_layers_test
