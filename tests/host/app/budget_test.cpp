// Protects when a render ends: which budget counts, and what remains of it.
#include "lxs/host/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxs/host/progress.h"
#include "lxsrender_process.h"

namespace lxs::test::budget_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Budget, EndsWhenEitherIsUsedUp) {
    const Budget budget{.passes = 4, .seconds = 10.0};
    EXPECT_FALSE(budget.used_up(3, 9.9));
    EXPECT_TRUE(budget.used_up(4, 0));
    EXPECT_TRUE(budget.used_up(0, 10));
}

TEST(Budget, RemainingIsTheShorterOfBoth) {
    const Budget budget{.passes = 4, .seconds = 10.0};
    EXPECT_DOUBLE_EQ(*budget.remaining(0, 0), 10);
    EXPECT_DOUBLE_EQ(*budget.remaining(1, 2), 6);
    EXPECT_DOUBLE_EQ(*budget.remaining(1, 8), 2);
    EXPECT_EQ((Budget{.passes = 4, .seconds = {}}).remaining(0, 1), std::nullopt);
}

TEST(Budget, SaysWhichIsUsedUpAndWhoAskedForIt) {
    const Budget budget{.passes = 4, .seconds = 10.0, .seconds_from = "the scene's halttime"};
    EXPECT_EQ(budget.why_over(3, 9.9), "");
    EXPECT_EQ(budget.why_over(4, 9.9), "as many as --passes asks for");
    EXPECT_EQ(budget.why_over(5, 9.9), "more than --passes asks for");  // a resumed render
    EXPECT_EQ(budget.why_over(3, 10), "the 10 s that the scene's halttime gives are over");
}

TEST(Progress, LineHoldsPassesAndTimeGoneAndLeft) {
    const RenderTotals totals{.passes = 3, .photon_paths = 3'000'000, .rays = 9000, .seconds = 75};
    EXPECT_EQ(progress_text(totals, {.passes = 6, .seconds = {}}),
              "pass 3 of 6, 1:15 gone, about 1:15 left");
    EXPECT_EQ(progress_text(totals, {.passes = {}, .seconds = 3675}),
              "pass 3, 1:15 gone, about 1:00:00 left");
    EXPECT_EQ(progress_text(totals, {}), "pass 3, 1:15 gone");
    EXPECT_EQ(speed_text(totals, 123'000'000), "40.0 k photons/s, 0.1 k rays/s, memory 123 MB");
}

TEST(Progress, EndSaysWhyThereAreNoMorePasses) {
    const RenderTotals totals{.passes = 1, .seconds = 2};
    const Budget budget{.passes = 1, .seconds = {}};
    EXPECT_EQ(ending_text(totals, budget, ""),
              "rendered 1 pass in 0:02: as many as --passes asks for");
    EXPECT_EQ(ending_text(totals, {.passes = {}, .seconds = 2}, ""),
              "rendered 1 pass in 0:02: the 2 s that --time gives are over");
    EXPECT_EQ(ending_text(totals, budget, "stopped by Ctrl-C or a signal"),
              "rendered 1 pass in 0:02: stopped by Ctrl-C or a signal");
}

std::string log_of(const std::string& film, std::vector<std::string> options) {
    TemporaryFolder folder;
    folder.write("scene.lxs", small_scene("Film \"fleximage\" \"integer xresolution\" [4] "
                                          "\"integer yresolution\" [4] \"string filename\" "
                                          "[\"out\"] " +
                                          film));
    options.insert(options.begin(), "scene.lxs");
    const RunResult result = run_lxsrender(folder, std::move(options));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err;
}

TEST(Budget, SceneBudgetCountsUnlessTheCommandLineHasOne) {
    EXPECT_THAT(log_of("\"integer haltspp\" [5]", {}),
                HasSubstr("rendered 5 passes in 0:00: as many as the scene's haltspp asks"));
    EXPECT_THAT(log_of("\"integer haltspp\" [5]", {"--passes", "2"}),
                HasSubstr("rendered 2 passes"));
    EXPECT_THAT(
        log_of("\"integer halttime\" [1]", {}),
        AllOf(HasSubstr("rendering 1 s"), HasSubstr(": the 1 s that the scene's halttime gives")));
    EXPECT_THAT(log_of("\"integer halttime\" [600]", {"--passes", "2"}),
                HasSubstr("rendered 2 passes"));
    EXPECT_THAT(log_of("\"integer haltspp\" [1000000000]", {"--time", "0.2"}),
                HasSubstr("rendering 0.2 s"));
}

TEST(Progress, LineAndEndHoldTheError) {
    const RenderTotals totals{.passes = 3, .seconds = 75};
    EXPECT_EQ(progress_text(totals, {}, "error 8.3 %"), "pass 3, 1:15 gone, error 8.3 %");
    const Budget budget{.passes = {}, .seconds = {}, .error = 0.05};
    EXPECT_EQ(budget.text(), "until the error is 5 %");
    EXPECT_EQ(
        ending_text(totals, budget, ""),
        "rendered 3 passes in 1:15: the error of 5 % that --target-error asks for is reached");
}

TEST(Budget, WithoutAnyBudgetSixteenPassesAndANotice) {
    const std::string log = log_of("", {});
    EXPECT_THAT(log, HasSubstr("says when to stop: rendering 16 passes"));
    EXPECT_THAT(log, HasSubstr("rendered 16 passes in 0:00: as many as the default asks for"));
}

}  // namespace
}  // namespace lxs::test::budget_test
