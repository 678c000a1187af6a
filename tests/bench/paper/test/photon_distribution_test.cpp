// Protects what Fig. 6 and 7 are made of: the density of the passes between two snapshots, and what
// is compared with what.
#include "photon_distribution.h"

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "image_file.h"
#include "map_picture.h"
#include "study_file.h"
#include "synthetic_image.h"

namespace bench::test::photon_distribution_test {
namespace {

constexpr int kSide = 64;

/// Left half `left`, right half `right`.
Image halves(double left, double right) {
    return synthetic_image(kSide, kSide, [=](int x, int) { return x < kSide / 2 ? left : right; });
}

class PhotonDistributionTest : public testing::Test {
  protected:
    /// An EXR as a run writes it: the image and layers of one channel.
    void write(const std::string& name, const Image& image, const Image& density,
               const Image* node_error) {
        Image all = channel(image, {"R", "G", "B"});
        all = OIIO::ImageBufAlgo::channel_append(all, channel(density, {"photondensity.Y"}));
        if (node_error != nullptr) {
            all = OIIO::ImageBufAlgo::channel_append(all, channel(*node_error, {"nodeerror.Y"}));
        }
        ASSERT_TRUE(all.write((folder_.path() / name).string(), OIIO::TypeDesc::FLOAT, "openexr"));
    }

    static Image channel(const Image& image, const std::vector<std::string>& names) {
        return OIIO::ImageBufAlgo::channels(image, int(names.size()), {}, {}, names);
    }

    static Json run(const std::string& name, const std::string& first, const std::string& second) {
        return {{"status", "done"},
                {"settings", {{"scene", "s"}, {"method", name}, {"seed", 1}}},
                {"snapshots",
                 Json::array({{{"pass", 1}, {"exr", first}}, {{"pass", 4}, {"exr", second}}})}};
    }

    TemporaryFolder folder_;
};

TEST_F(PhotonDistributionTest, DensityBetweenSnapshotsAndWhatItFollows) {
    // Truth: right half bright. Unguided: even density, its error on the left. Guided: even at
    // first, then passes 2 to 4 all on the left, so that the mean over 4 passes is (7, 1) / 4.
    References references;
    references.image = {halves(1, 4), halves(1, 4)};
    const Image error = halves(1, 0);
    write("plain1.exr", halves(2, 4), halves(1, 1), nullptr);
    write("plain4.exr", halves(2, 4), halves(1, 1), nullptr);
    write("guided1.exr", halves(1, 4), halves(1, 1), &error);
    write("guided4.exr", halves(1, 4), halves(1.75, 0.25), &error);
    const Json runs = Json::array(
        {run("plain", "plain1.exr", "plain4.exr"), run("guided", "guided1.exr", "guided4.exr")});
    Experiment experiment;
    experiment.cases = {{"plain", "plain", "", {}, "plain"}, {"guided", "guided", "", {}, "plain"}};
    const Json found = photon_distribution(
        {experiment, "s", runs, 1, folder_.path(), folder_.path() / "images", references});

    EXPECT_EQ(found["block_px"], 2);
    const Json& plain = found["rows"][0]["stages"][1];
    EXPECT_EQ(plain["first_pass"], 2);
    EXPECT_EQ(plain["last_pass"], 4);
    EXPECT_NEAR(plain["unevenness"], 0, 1e-6);
    EXPECT_NEAR(plain["highlight_share"], 0.1, 1e-3);  // a tenth of the pixels, even density
    EXPECT_TRUE(plain["distance"].is_null());          // no second seed to compare with
    const Json& guided = found["rows"][1]["stages"][1];
    EXPECT_NEAR(guided["highlight_share"], 0, 1e-6);
    EXPECT_NEAR(guided["unevenness"], 1, 1e-5);
    EXPECT_NEAR(guided["distance"], 0.5, 1e-5);
    EXPECT_NEAR(guided["added_error_correlation"], 1, 1e-9);
    EXPECT_NEAR(guided["added_node_error_correlation"], 1, 1e-9);
    EXPECT_NEAR(found["rows"][1]["stages"][0]["distance"], 0, 1e-9);

    // Pictures with one exposure: the unguided density is white.
    const Image picture((folder_.path() / "images/s.guided.passes-2-4.png").string());
    ASSERT_EQ(picture.spec().width, kSide) << picture.geterror();
    EXPECT_FLOAT_EQ(picture.getchannel(0, 0, 0, 0), 1);
    EXPECT_FLOAT_EQ(picture.getchannel(kSide - 1, 0, 0, 0), 0);
}

TEST_F(PhotonDistributionTest, ARunWithoutTheLayerIsRefused) {
    write_layers(folder_.path() / "a.exr", {{"", halves(1, 1)}});
    EXPECT_FALSE(read_map(folder_.path() / "a.exr", "photondensity"));
    References references;
    references.image = {halves(1, 4), halves(1, 4)};
    const Json runs = Json::array({run("plain", "a.exr", "a.exr")});
    Experiment experiment;
    experiment.cases = {{"plain", "plain", "", {}, "plain"}};
    EXPECT_THROW(photon_distribution({experiment, "s", runs, 1, folder_.path(),
                                      folder_.path() / "images", references}),
                 StudyError);
}

}  // namespace
}  // namespace bench::test::photon_distribution_test
