// Protects debug layers over the passes: which methods, snapshots and layers are shown, on one
// scale, and that they keep to their share of the page.
#include "photon_strips.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "image_file.h"
#include "synthetic_image.h"
#include "synthetic_study.h"

namespace bench::test::photon_strips_test {
namespace {

class PhotonStripsTest : public testing::Test {
  protected:
    PhotonStripsTest() { summary_ = write_synthetic_study(folder_.path()); }
    Json strips(double bytes) const {
        return report_photon_strips(folder_.path() / "study", summary_["runs"], summary_["study"],
                                    bytes);
    }
    static double size_of(const Json& found) {
        double bytes = 0;
        for (const Json& scene : found["scenes"]) {
            for (const Json& layer : scene["layers"]) {
                for (const Json& row : layer["rows"]) {
                    for (const Json& picture : row["pictures"])
                        bytes += double(picture["image"].get<std::string>().size());
                }
            }
        }
        return bytes;
    }
    TemporaryFolder folder_;
    Json summary_;
};

std::vector<std::string> layer_names(const Json& scene) {
    std::vector<std::string> names;
    for (const Json& layer : scene.at("layers"))
        names.push_back(layer.at("layer"));
    return names;
}

TEST_F(PhotonStripsTest, SnapshotsOfTheMethodsThatHaveTheLayers) {
    const Json found = strips(1e6);
    ASSERT_EQ(found["scenes"].size(), 1u);  // the other scene's images have none
    const Json& scene = found["scenes"][0];
    EXPECT_EQ(scene["scene"], kPlainScene);
    EXPECT_EQ(layer_names(scene),
              (std::vector<std::string>{"photondensity", "nodeerror", "nodeweight", "guidedshare",
                                        "nodeedges"}));
    EXPECT_EQ(found["columns"], (Json{nullptr, 1.0, 2.0, 4.0}));
    const Json& density = scene["layers"][0];
    ASSERT_EQ(density["rows"].size(), 2u);
    EXPECT_EQ(density["rows"][0]["method"], "sppm");
    EXPECT_EQ(scene["layers"][1]["rows"].size(), 1u);
    EXPECT_EQ(scene["layers"][1]["rows"][0]["method"], "better");
    const Json& pictures = density["rows"][1]["pictures"];
    ASSERT_EQ(pictures.size(), 4u);
    EXPECT_EQ(pictures[0]["pass"], 5);
    EXPECT_EQ(pictures[3]["pass"], 42);
    EXPECT_EQ(pictures[3]["seconds"], 4.2);
}

TEST_F(PhotonStripsTest, OneScaleForAllPicturesOfALayer) {
    const Json found = strips(1e6);
    const Json& layers = found["scenes"][0]["layers"];
    EXPECT_TRUE(layers[0]["logarithmic"]);
    // Equal maps, equal pictures; of a share that grows with time no two are alike.
    EXPECT_EQ(layers[0]["rows"][0]["pictures"][0]["image"],
              layers[0]["rows"][1]["pictures"][3]["image"]);
    const Json& growing = layers[1]["rows"][0]["pictures"];
    for (std::size_t i = 1; i < growing.size(); ++i)
        EXPECT_NE(growing[i]["image"], growing[i - 1]["image"]) << i;
    for (const std::size_t share : {3u, 4u}) {
        EXPECT_EQ(layers[share]["low"], 0.0);
        EXPECT_EQ(layers[share]["high"], 1.0);
    }
}

TEST_F(PhotonStripsTest, LayersThatDoNotFitAreLeftOutAndNamed) {
    const double all = size_of(strips(1e6));
    EXPECT_EQ(strips(all)["left_out"], Json::array());
    const Json fewer = strips(all - 1);
    EXPECT_EQ(fewer["left_out"], (Json{"nodeedges"}));
    EXPECT_EQ(layer_names(fewer["scenes"][0]).size(), 4u);
    const Json none = strips(0);
    EXPECT_EQ(none["left_out"].size(), 5u);
    EXPECT_TRUE(none["scenes"].empty());
}

TEST_F(PhotonStripsTest, PicturesShrinkBeforeLayersAreLeftOut) {
    std::mt19937 random(1);
    const Image noise = noisy_image(200, 100, 1, 0.3, random);
    const NamedLayer density{"photondensity", OIIO::ImageBufAlgo::channels(noise, 1, 0)};
    for (int time = 0; time < 4; ++time) {
        const std::string name = fmt::format("study/images/sppm.{}.exr", time);
        write_layers(folder_.path() / name, {{"", noise}, density});
    }
    summary_["study"]["methods"] = {"sppm"};
    const double all = size_of(strips(1e6));
    for (const double share : {0.6, 0.3}) {  // (112 / 160)^2 and (80 / 160)^2 of the pixels
        const Json smaller = strips(share * all);
        EXPECT_EQ(smaller["left_out"], Json::array());
        EXPECT_LE(size_of(smaller), share * all);
        EXPECT_GT(size_of(smaller), share * all / 2);
    }
    EXPECT_EQ(strips(0.1 * all)["left_out"], (Json{"photondensity"}));
}

TEST_F(PhotonStripsTest, NothingWithoutLayers) {
    summary_["study"]["methods"] = {"worse"};
    EXPECT_TRUE(strips(1e6).is_null());
}

}  // namespace
}  // namespace bench::test::photon_strips_test
