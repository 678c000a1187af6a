// Protects tables of errors: what a cell is, which is the least, what is together in a column.
#include "error_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bench::test::error_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Json run(const char* scene, const char* method, const char* variant, double budget_s,
         const Json& relmse) {
    const Json image = {{"relmse", relmse}, {"mse", 7}};
    return {{"status", "done"},
            {"settings", {{"scene", scene}, {"method", method}, {"variant", variant}}},
            {"at_budget", {{{"clock", "cpu"}, {"budget_s", budget_s}, {"image", image}}}}};
}

ShownStudy study(const std::vector<Json>& runs, const char* name = "") {
    const Json settings = {{"variants", {"shipped"}}, {"budgets_s", {5, 20}}};
    return {{{"study", settings}, {"runs", runs}}, name};
}

const ShownError kRelative{"relmse", "cpu", std::nullopt};

TEST(ErrorTable, HasMeansOverSeedsAndTheLeastInBold) {
    const auto text = error_table(
        {study({run("hall", "path", "any", 20, 0.01), run("hall", "path", "any", 20, 0.03),
                run("hall", "aips", "shipped", 20, 0.004), run("pool", "path", "any", 20, 1690.0),
                run("pool", "aips", "shipped", 20, 15300.0)})},
        kRelative);
    EXPECT_EQ(text,
              "relmse after 20 cpu seconds, mean over seeds:\n\n"
              "| scene | path | aips |\n"
              "| --- | --- | --- |\n"
              "| hall | 0.02 | **0.004** |\n"
              "| pool | **1700** | 1.5e+04 |\n"
              "| over the last, geometric mean | 0.74 | 1 |\n");
}

TEST(ErrorTable, LeavesOutWhatIsNotThere) {
    Json failed = run("hall", "path", "any", 20, 0.01);
    failed["status"] = "failed";
    const auto text = error_table(
        {study({failed, run("hall", "path", "any", 5, 0.5),
                run("hall", "aips", "shipped", 20, -0.1),
                run("hall", "sppm", "shipped", 20, nullptr), run("pool", "path", "any", 20, 0.1)})},
        kRelative);
    EXPECT_THAT(text, HasSubstr("| hall | - | |\n| pool | | **0.1** |\n"));
    EXPECT_THAT(text, HasSubstr("geometric mean | | 1 |"));
}

TEST(ErrorTable, JoinsStudiesByTheNamesOfColumns) {
    const auto first = study({run("hall", "aips", "shipped", 5, 0.1)});
    const auto second = study({run("hall", "aips", "shipped", 5, 0.3)});
    const ShownError after_five{"relmse", "cpu", 5};
    EXPECT_THAT(error_table({first, second}, after_five), HasSubstr("| hall | **0.2** |"));
    const auto named = study({run("hall", "aips", "shipped", 5, 0.3)}, "photons alone");
    const auto text = error_table({first, named}, after_five);
    EXPECT_THAT(text, HasSubstr("| scene | aips | photons alone |"));
    EXPECT_THAT(text, HasSubstr("| hall | **0.1** | 0.3 |"));
    EXPECT_THAT(text, Not(HasSubstr("shipped")));
}

TEST(ErrorTable, TellsVariantsApartWhereThereAreSeveral) {
    auto both = study({run("hall", "aips", "shipped", 20, 0.1),
                       run("hall", "aips", "fixed", 20, 0.2), run("hall", "path", "any", 20, 0.3)});
    both.summary["study"]["variants"] = {"fixed", "shipped"};
    EXPECT_THAT(error_table({both}, kRelative),
                HasSubstr("| scene | aips, shipped | aips, fixed | path |"));
}

TEST(ErrorTable, NeedsAnError) {
    const auto one = study({run("hall", "aips", "shipped", 20, 0.1)});
    EXPECT_THROW(error_table({one}, {"relmse", "cpu", 60}), StudyError);
    EXPECT_THROW(error_table({one}, {"relmse", "wall", 20}), StudyError);
}

}  // namespace
}  // namespace bench::test::error_table_test
