// Protects the order of runs, so that machine drift hits all methods alike.
#include "study_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bench::test::study_plan_test {
namespace {

MethodTable small_table() {
    MethodTable table;
    table.methods = {{"path", "", "path", "", {}, false},
                     {"sppm", "", "sppm", "", {}, true},
                     {"paper", "", "aips", "", {"guide=paper"}, true}};
    table.photons_per_pass = 1000;
    table.fixed_startradius = 2;
    return table;
}

Study small_study() {
    Study study;
    study.scenes = {{"furnace", std::string(BENCH_SCENES) + "/furnace.lxs"}};
    study.methods = {"path", "sppm", "paper"};
    study.variants = {"fixed", "shipped"};
    study.seeds = 2;
    study.budgets_s = {1};
    study.set = {"aips.guideshare=0.3"};
    return study;
}

TEST(StudyPlan, InterleavesMethodsSeedBySeed) {
    std::vector<std::string> order;
    for (const RunSettings& run : plan_runs(small_study(), small_table()))
        order.push_back(run_name(run));
    const std::vector<std::string> expected{"furnace.path.any.s1",      "furnace.sppm.fixed.s1",
                                            "furnace.paper.fixed.s1",   "furnace.sppm.shipped.s1",
                                            "furnace.paper.shipped.s1", "furnace.path.any.s2",
                                            "furnace.sppm.fixed.s2",    "furnace.paper.fixed.s2",
                                            "furnace.sppm.shipped.s2",  "furnace.paper.shipped.s2"};
    EXPECT_EQ(order, expected);
}

TEST(StudyPlan, VariantsDifferByRadiusAloneAndOverridesReachTheirIntegrator) {
    const auto runs = plan_runs(small_study(), small_table());
    EXPECT_TRUE(runs[0].set.empty());
    EXPECT_EQ(runs[2].set, (std::vector<std::string>{"aips.photonperpass=1000", "aips.guide=paper",
                                                     "aips.alpha=1", "aips.startradius=2",
                                                     "aips.guideshare=0.3"}));
    EXPECT_EQ(runs[4].set, (std::vector<std::string>{"aips.photonperpass=1000", "aips.guide=paper",
                                                     "aips.guideshare=0.3"}));
    EXPECT_EQ(startradius(runs[2].set), 2);
    EXPECT_FALSE(startradius(runs[4].set));
}

TEST(StudyPlan, SettingsSurviveTheirFile) {
    for (const RunSettings& run : plan_runs(small_study(), small_table()))
        EXPECT_EQ(to_json(run_settings_from(to_json(run))), to_json(run));
}

}  // namespace
}  // namespace bench::test::study_plan_test
