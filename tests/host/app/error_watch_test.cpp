// Protects renders that end at an error: after how many passes it is compared, that the scene and
// the command line can ask for it, that a pause changes nothing, and that it can be switched off.
#include "lxs/host/error_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::error_watch_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Options = std::vector<std::string>;

/// A sphere under a lamp that has a size, and with it noise.
class ErrorWatchTest : public testing::Test {
  protected:
    ErrorWatchTest() { write_scene(""); }

    void write_scene(const std::string& film) const {
        folder_.write("scene.lxs",
                      small_scene("Film \"fleximage\" \"integer xresolution\" [8] "
                                  "\"integer yresolution\" [6] \"string filename\" [\"out\"] " +
                                      film,
                                  "AttributeBegin\nAreaLightSource \"area\"\nTranslate 0 0 4\n"
                                  "Shape \"sphere\" \"float radius\" [1.5]\nAttributeEnd\n"));
    }
    RunResult run(Options options) const {
        options.insert(options.begin(),
                       {"scene.lxs", "--integrator", "path", "--stats", "stats.json"});
        return run_lxsrender(folder_, std::move(options));
    }
    nlohmann::json statistics() const { return nlohmann::json::parse(folder_.read("stats.json")); }
    std::uint64_t passes() const { return statistics()["counts"]["passes"]; }

    TemporaryFolder folder_;
};

TEST(ErrorWatch, ComparesAfterEightPassesAndThenEverMoreSeldom) {
    std::vector<std::uint64_t> compared;
    for (std::uint64_t passes = 0; passes < 27; passes = compared.back() + 1)
        compared.push_back(next_comparison(passes));
    EXPECT_THAT(compared,
                testing::ElementsAre(8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 24, 27));
}

TEST_F(ErrorWatchTest, EndsAtTheErrorThatTheCommandLineNames) {
    const RunResult result = run({"--target-error", "0.05"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("rendering until the error is 5 %"));
    EXPECT_THAT(result.err,
                HasSubstr("the error of 5 % that --target-error asks for is reached; the "
                          "estimated error is "));
    const auto json = statistics();
    EXPECT_LE(json["estimated error"]["relative"], 0.05);
    EXPECT_EQ(json["settings"]["target error"], 0.05);
    const std::uint64_t at_five = passes();
    EXPECT_EQ(next_comparison(at_five), at_five);
    ASSERT_EQ(run({"--target-error", "0.02"}).exit_code, 0);
    EXPECT_GT(passes(), 2 * at_five);
}

TEST_F(ErrorWatchTest, EndsAtTheErrorThatTheSceneNames) {
    ASSERT_EQ(run({"--target-error", "0.05"}).exit_code, 0);
    const std::uint64_t at_five = passes();
    write_scene("\"float haltthreshold\" [0.05]");
    ASSERT_EQ(run({}).exit_code, 0);
    EXPECT_EQ(passes(), at_five);
    ASSERT_EQ(run({"--passes", "5"}).exit_code, 0);  // the command line overrides it
    EXPECT_EQ(passes(), 5u);
    write_scene("\"float haltthreshold\" [0.0001] \"integer haltspp\" [12]");
    ASSERT_EQ(run({}).exit_code, 0);  // whichever is first
    EXPECT_EQ(passes(), 12u);
}

TEST_F(ErrorWatchTest, APauseChangesNothing) {
    ASSERT_EQ(run({"--target-error", "0.04"}).exit_code, 0);
    const std::uint64_t whole = passes();
    const std::string image = folder_.read("out.exr");
    const nlohmann::json error = statistics()["estimated error"];
    const Options check{"--checkpoint", "check", "--resume"};
    Options begin{"--passes", "11"}, end{"--target-error", "0.04"};
    begin.insert(begin.end(), check.begin(), check.end());
    end.insert(end.end(), check.begin(), check.end());
    ASSERT_EQ(run(begin).exit_code, 0);
    ASSERT_EQ(run(end).exit_code, 0);
    EXPECT_EQ(passes(), whole);
    EXPECT_EQ(folder_.read("out.exr"), image);
    EXPECT_EQ(statistics()["estimated error"], error);
    ASSERT_EQ(run(end).exit_code, 0);  // it is reached already
    EXPECT_EQ(passes(), whole);
}

TEST_F(ErrorWatchTest, CanBeSwitchedOff) {
    ASSERT_EQ(run({"--passes", "4"}).exit_code, 0);
    EXPECT_THAT(folder_.read("out.exr"), HasSubstr("error.G"));
    const RunResult result = run({"--passes", "4", "--no-error-estimate"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("error")));
    EXPECT_THAT(folder_.read("out.exr"), Not(HasSubstr("error.G")));
    EXPECT_FALSE(statistics().contains("estimated error"));
    EXPECT_EQ(run({"--target-error", "0.1", "--no-error-estimate"}).exit_code, 2);
    write_scene("\"float haltthreshold\" [0.05]");
    EXPECT_THAT(run({"--no-error-estimate"}).err, HasSubstr("haltthreshold has no effect"));
}

TEST_F(ErrorWatchTest, ACheckpointWithoutTheEstimateIsRefused) {
    const Options check{"--passes", "4", "--checkpoint", "check", "--resume"};
    Options without = check;
    without.emplace_back("--no-error-estimate");
    ASSERT_EQ(run(without).exit_code, 0);
    const RunResult result = run(check);
    EXPECT_EQ(result.exit_code, 6);
    EXPECT_THAT(result.err, HasSubstr("saved without an estimate of the error"));
}

}  // namespace
}  // namespace lxs::test::error_watch_test
