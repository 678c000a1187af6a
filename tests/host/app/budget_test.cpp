// Protects when a render ends: which budget counts, and what remains of it.
#include "lxs/host/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxs/host/progress.h"
#include "lxsrender_process.h"

namespace lxs::test::budget_test {
namespace {

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

TEST(Progress, LineHoldsPassSpeedTimeAndMemory) {
    const RenderTotals totals{.passes = 3, .photon_paths = 3'000'000, .rays = 9000, .seconds = 75};
    EXPECT_EQ(progress_text(totals, {.passes = 6, .seconds = {}}, 123'000'000),
              "pass 3/6  40.0 k photons/s  0.1 k rays/s  elapsed 1:15  remaining 1:15  memory 123 "
              "MB");
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
    EXPECT_THAT(log_of("\"integer haltspp\" [5]", {}), HasSubstr("rendered pass 5 "));
    EXPECT_THAT(log_of("\"integer haltspp\" [5]", {"--passes", "2"}),
                HasSubstr("rendered pass 2 "));
    EXPECT_THAT(log_of("\"integer halttime\" [1]", {}), HasSubstr("rendering 1 s"));
    EXPECT_THAT(log_of("\"integer halttime\" [600]", {"--passes", "2"}),
                HasSubstr("rendered pass 2 "));
    EXPECT_THAT(log_of("\"integer haltspp\" [1000000000]", {"--time", "0.2"}),
                HasSubstr("rendering 0.2 s"));
}

TEST(Progress, LineHoldsTheErrorBeforeTheMemory) {
    EXPECT_THAT(progress_text({.passes = 3, .seconds = 75}, {}, 123'000'000, "error 8.3 %"),
                HasSubstr("elapsed 1:15  error 8.3 %  memory 123 MB"));
}

TEST(Budget, WithoutAnyBudgetSixteenPassesAndANotice) {
    const std::string log = log_of("", {});
    EXPECT_THAT(log, HasSubstr("says when to stop: rendering 16 passes"));
    EXPECT_THAT(log, HasSubstr("rendered pass 16 "));
}

}  // namespace
}  // namespace lxs::test::budget_test
