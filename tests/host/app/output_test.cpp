// Protects the outputs: their names, that they appear whole or not at all, and that a place that
// can't be written is found before rendering.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::output_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class OutputTest : public testing::Test {
  protected:
    OutputTest() { folder_.write("scene.lxs", small_scene()); }
    RunResult run(std::vector<std::string> options) {
        options.insert(options.begin(), {"scene.lxs", "--passes", "2"});
        return run_lxsrender(folder_, std::move(options));
    }
    TemporaryFolder folder_;
};

TEST_F(OutputTest, NamesComeFromTheFilmOrFromTheCommandLine) {
    EXPECT_EQ(run({}).exit_code, 0);
    EXPECT_TRUE(folder_.has("out.exr"));
    EXPECT_TRUE(folder_.has("out.png"));
    EXPECT_EQ(run({"-o", "other.exr"}).exit_code, 0);
    EXPECT_TRUE(folder_.has("other.exr"));
    EXPECT_TRUE(folder_.has("other.png"));
}

TEST_F(OutputTest, ANameOfAPngMeansThePngAlone) {
    EXPECT_EQ(run({"-o", "other.exr"}).exit_code, 0);
    const RunResult result = run({"-o", "alone.PNG"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("wrote alone.PNG\n"));
    EXPECT_EQ(folder_.read("alone.PNG"), folder_.read("other.png"));
    EXPECT_EQ(folder_.entries(), 4u);  // scene, EXR, two PNGs
}

TEST_F(OutputTest, ExposureIsThePngsAlone) {
    for (const char* stops : {"0", "1", "-60"}) {
        const std::string name = std::string("by") + stops;
        ASSERT_EQ(run({"-o", name + ".exr", "--exposure", stops}).exit_code, 0);
        EXPECT_EQ(folder_.read(name + ".exr"), folder_.read("by0.exr"));
    }
    EXPECT_NE(folder_.read("by1.png"), folder_.read("by0.png"));
    EXPECT_THAT(run({"--exposure", "-60"}).err,
                HasSubstr("the image is all black; the likely reason: the exposure: luminances"));
}

TEST_F(OutputTest, NoTemporaryFilesStayBehind) {
    EXPECT_EQ(run({"--stats", "stats.json"}).exit_code, 0);
    EXPECT_EQ(folder_.entries(), 4u);  // scene, EXR, PNG, statistics
}

TEST_F(OutputTest, SameSceneAndSeedGiveTheSameFileForAnyNumberOfThreads) {
    ASSERT_EQ(run({"-o", "one.exr", "--threads", "1"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "two.exr", "--threads", "2"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "seven.exr", "--threads", "7"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "seed.exr", "--seed", "5"}).exit_code, 0);
    EXPECT_EQ(folder_.read("one.exr"), folder_.read("two.exr"));
    EXPECT_EQ(folder_.read("one.exr"), folder_.read("seven.exr"));
    EXPECT_NE(folder_.read("one.exr"), folder_.read("seed.exr"));
}

TEST_F(OutputTest, UnwritablePlacesAreFoundBeforeRendering) {
    folder_.write("file", "");
    const struct {
        std::vector<std::string> options;
        std::string message;
    } cases[] = {
        {{"-o", "nowhere/a.exr"}, "error: cannot write 'nowhere/a.exr': No such file or directory"},
        {{"-o", "file/a.exr"}, "error: cannot write 'file/a.exr': Not a directory"},
        {{"-o", "/proc/a.exr"}, "error: cannot write '/proc/a.exr': "},
        {{"--stats", "nowhere/s.json"}, "error: cannot write 'nowhere/s.json': No such file"},
        {{"--stats", "."}, "error: cannot write '.': Is a directory"},
    };
    for (const auto& [options, message] : cases) {
        const RunResult result = run(options);
        EXPECT_EQ(result.exit_code, 5) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_THAT(result.err, Not(HasSubstr("rendering")));
    }
}

TEST_F(OutputTest, StatisticsHoldSettingsFactsTimesAndCounts) {
    ASSERT_EQ(run({"--stats", "stats.json", "--seed", "3", "--threads", "2"}).exit_code, 0);
    const auto json = nlohmann::json::parse(folder_.read("stats.json"));
    EXPECT_EQ(json["settings"]["integrator"], "path");
    EXPECT_EQ(json["settings"]["seed"], 3);
    EXPECT_EQ(json["scene"]["lights"], 1);
    EXPECT_EQ(json["scene"]["width"], 8);
    EXPECT_EQ(json["counts"]["passes"], 2);
    EXPECT_EQ(json["path"]["paths"], 2 * 8 * 6);
    EXPECT_EQ(json["path"]["refused contributions"], 0);
    EXPECT_GE(json["counts"]["rays"], 2 * 8 * 6);
    EXPECT_GT(json["peak memory bytes"], 1'000'000);
    for (const char* phase : {"load", "build", "render", "write"}) {
        EXPECT_TRUE(json["seconds"].contains(phase)) << phase;
    }
    EXPECT_FALSE(json["interrupted"]);
}

TEST_F(OutputTest, ExrHeaderHoldsHowItWasMade) {
    ASSERT_EQ(run({}).exit_code, 0);
    const std::string exr = folder_.read("out.exr");
    for (const char* key : {"integrator", "passes", "seed", "scene", "software"}) {
        EXPECT_THAT(exr, HasSubstr(key));
    }
    EXPECT_THAT(exr, Not(HasSubstr("relMSE")));  // two passes don't tell
    ASSERT_EQ(run_lxsrender(folder_, {"scene.lxs", "--passes", "3"}).exit_code, 0);
    for (const char* key : {"relMSE", "relMSEInterval", "relMSEWhole", "RMSE", "RMSEInterval"}) {
        EXPECT_THAT(folder_.read("out.exr"), HasSubstr(key));
    }
}

}  // namespace
}  // namespace lxs::test::output_test
