// Protects --width, --height, --sampler and --set of a sampler: they stand above the scene's
// statements, and what they make wrong is reported at the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::statement_override_test {
namespace {

using testing::HasSubstr;

class StatementOverrideTest : public testing::Test {
  protected:
    StatementOverrideTest() { folder_.write("scene.lxs", small_scene()); }
    RunResult run(std::vector<std::string> options) {
        options.insert(options.begin(), {"scene.lxs", "--passes", "1", "--stats", "stats.json"});
        return run_lxsrender(folder_, std::move(options));
    }
    nlohmann::json scene_facts() {
        return nlohmann::json::parse(folder_.read("stats.json")).at("scene");
    }
    TemporaryFolder folder_;
};

TEST_F(StatementOverrideTest, HeightFollowsTheWidth) {
    ASSERT_EQ(run({"--width", "20"}).exit_code, 0);  // the scene's own: 8 x 6
    EXPECT_EQ(scene_facts()["width"], 20);
    EXPECT_EQ(scene_facts()["height"], 15);
    ASSERT_EQ(run({"--width", "1"}).exit_code, 0);
    EXPECT_EQ(scene_facts()["height"], 1);
}

TEST_F(StatementOverrideTest, HeightOfItsOwn) {
    ASSERT_EQ(run({"--height", "9"}).exit_code, 0);
    EXPECT_EQ(scene_facts()["width"], 8);
    EXPECT_EQ(scene_facts()["height"], 9);
    ASSERT_EQ(run({"--width", "20", "--height", "20"}).exit_code, 0);
    EXPECT_EQ(scene_facts()["width"], 20);
    EXPECT_EQ(scene_facts()["height"], 20);
}

TEST_F(StatementOverrideTest, SamplerTakesParametersLikeAnIntegrator) {
    const RunResult set = run({"--integrator", "path", "--sampler", "metropolis", "--set",
                               "metropolis.maxconsecrejects=7", "--strict", "--verbose"});
    EXPECT_EQ(set.exit_code, 0) << set.err;
    EXPECT_THAT(set.err, HasSubstr("maxconsecrejects 7"));
    const RunResult unknown = run({"--integrator", "path", "--sampler", "metropolis", "--set",
                                   "metropolis.maxconsecreject=7"});
    EXPECT_EQ(unknown.exit_code, 3);
    EXPECT_THAT(unknown.err, HasSubstr("unknown metropolis parameter"));
    const RunResult other = run({"--set", "metropolis.maxconsecrejects=7"});
    EXPECT_EQ(other.exit_code, 0);
    EXPECT_THAT(other.err, HasSubstr("has no effect: the sampler is another"));
}

TEST_F(StatementOverrideTest, WidthWorksWithoutAFilmStatement) {
    folder_.write("scene.lxs", "WorldBegin\nLightSource \"point\"\nShape \"sphere\"\nWorldEnd\n");
    ASSERT_EQ(run({"--width", "8", "-o", "a.exr"}).exit_code, 0);  // default: 800 x 600
    EXPECT_EQ(scene_facts()["height"], 6);
}

TEST_F(StatementOverrideTest, CropWindowKeepsItsFractions) {
    folder_.write("scene.lxs", small_scene("Film \"fleximage\" \"integer xresolution\" [80]\n"
                                           "  \"integer yresolution\" [40]\n"
                                           "  \"float cropwindow\" [0.25 0.5 0 0.5]\n"));
    ASSERT_EQ(run({"--width", "40", "-o", "a.exr"}).exit_code, 0);
    EXPECT_EQ(scene_facts()["width"], 10);
    EXPECT_EQ(scene_facts()["height"], 10);
}

TEST_F(StatementOverrideTest, SamplerIsReplacedAndAnUnknownOneIsAnError) {
    folder_.write("scene.lxs",
                  small_scene("Sampler \"metropolis\" \"float largemutationprob\" [0.3]\n"));
    // The parameters of another sampler go with it.
    ASSERT_EQ(run({"--sampler", "random", "--strict"}).exit_code, 0);
    const RunResult unknown = run({"--sampler", "randm"});
    EXPECT_EQ(unknown.exit_code, 3);
    EXPECT_THAT(unknown.err, HasSubstr("command line: --sampler randm: error: unknown Sampler"));
    EXPECT_EQ(run({"--width", "0"}).exit_code, 2);
}

}  // namespace
}  // namespace lxs::test::statement_override_test
