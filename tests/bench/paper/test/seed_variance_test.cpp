// Protects the noise of a case: the variance over its seeds, relative to the mean of both that are
// compared.
#include "seed_variance.h"

#include <gtest/gtest.h>

#include "bench_process.h"
#include "image_file.h"
#include "study_file.h"
#include "synthetic_image.h"

namespace bench::test::seed_variance_test {
namespace {

class SeedVarianceTest : public testing::Test {
  protected:
    Json run(const std::string& name, unsigned seed, double value) {
        const std::string file = name + std::to_string(seed) + ".exr";
        const Image image = synthetic_image(4, 4, [=](int, int) { return value; });
        // The image itself is noisier than the part that is asked for.
        const Image other = synthetic_image(4, 4, [=](int, int) { return 100 * seed; });
        write_layers(folder_.path() / file, {{"", other}, {kPhotonLayer, image}});
        return {{"status", "done"},
                {"settings", {{"scene", "s"}, {"method", name}, {"seed", seed}}},
                {"snapshots", Json::array({{{"exr", file}}})}};
    }

    TemporaryFolder folder_;
    Json scene_ = {{"scene", "s"},
                   {"rows", Json::array({{{"case", "a"}, {"against", "b"}},
                                         {{"case", "b"}, {"against", "b"}}})}};
};

TEST_F(SeedVarianceTest, RelativeToTheMeanOfBothCases) {
    Experiment experiment;
    experiment.part = "photons";
    experiment.cases = {{"a", "a", "", {}, "b"}, {"b", "b", "", {}, "b"}};
    // Means 1, sample variances 2 x 0.1^2 and 2 x 0.2^2.
    const Json runs =
        Json::array({run("a", 1, 0.9), run("a", 2, 1.1), run("b", 1, 0.8), run("b", 2, 1.2)});
    add_seed_variance(experiment, runs, 2, folder_.path(), scene_);
    EXPECT_NEAR(scene_["rows"][0]["relative_variance"], 0.02 / 1.0001, 1e-6);
    EXPECT_NEAR(scene_["rows"][0]["variance_ratio"], 0.25, 1e-5);
    EXPECT_EQ(scene_["rows"][1]["variance_ratio"], 1);
}

TEST_F(SeedVarianceTest, OneSeedSaysNothing) {
    Experiment experiment;
    experiment.part = "photons";
    experiment.cases = {{"a", "a", "", {}, "b"}, {"b", "b", "", {}, "b"}};
    const Json runs = Json::array({run("a", 1, 0.9), run("b", 1, 0.8), run("b", 2, 1.2)});
    add_seed_variance(experiment, runs, 2, folder_.path(), scene_);
    EXPECT_TRUE(scene_["rows"][0]["relative_variance"].is_null());
    EXPECT_TRUE(scene_["rows"][0]["variance_ratio"].is_null());
    EXPECT_EQ(scene_["rows"][1]["variance_ratio"], 1);
}

}  // namespace
}  // namespace bench::test::seed_variance_test
