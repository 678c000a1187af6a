// Protects a report's data and the page that holds it, up to the browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bench_process.h"
#include "report_command.h"
#include "report_page.h"
#include "study_file.h"
#include "synthetic_study.h"

namespace bench::test::report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportPage, NoStringEndsTheScriptElement) {
    const Json data{{"</script>", "<!-- <script> </SCRIPT> \\u003c \" & \xE2\x80\xA8"},
                    {"number", 0.1}};
    const std::string safe = script_safe_json(data);
    EXPECT_THAT(safe, Not(HasSubstr("<")));
    EXPECT_EQ(Json::parse(safe), data);
}

TEST(ReportPage, BytesThatAreNoTextDoNotSpoilIt) {
    const Json read = Json::parse(script_safe_json({{"message", "log \xFF\xFE end"}}));
    EXPECT_THAT(read["message"].get<std::string>(), testing::EndsWith(" end"));
}

TEST(ReportPage, DataTakesThePlaceOfTheMark) {
    const std::string page = std::string("<p>") + kReportDataMark + "</p>";
    EXPECT_EQ(fill_page(page, {{"a", "$&"}}), R"(<p>{"a":"$&"}</p>)");
    EXPECT_THROW(fill_page("<p></p>", {}), StudyError);
    EXPECT_THROW(fill_page(page + page, {}), StudyError);
}

const Json& find(const Json& list, const Json& wanted) {
    for (const Json& entry : list) {
        bool same = true;
        for (const auto& [key, value] : wanted.items())
            same = same && entry.at(key) == value;
        if (same) return entry;
    }
    throw std::out_of_range("no entry " + wanted.dump());
}

class ReportDataTest : public testing::Test {
  protected:
    ReportDataTest() {
        const Json summary = write_synthetic_study(folder_.path());
        ReferenceCache references(folder_.path() / "references");
        data_ = report_data(folder_.path() / "study", summary, references);
    }
    TemporaryFolder folder_;
    Json data_;
};

TEST_F(ReportDataTest, CurvesHaveTheSlopesAndMeansOfTheirPowerLaws) {
    // Scenes, variants, methods, clocks, metrics; one scene has a photon part, too.
    EXPECT_EQ(data_["curves"].size(), (2u + 1) * 2 * 3 * 2 * 3);
    const Json& curve = find(data_["curves"], {{"scene", kPlainScene},
                                               {"variant", "fixed"},
                                               {"method", "better"},
                                               {"part", "image"},
                                               {"clock", "cpu"},
                                               {"metric", "relmse"}});
    EXPECT_NEAR(curve["slope"], -1, 1e-9);
    EXPECT_NEAR(curve["slope_low"], -1, 1e-9);
    ASSERT_EQ(curve["mean"].size(), 4u);  // half a budget and the budgets
    EXPECT_NEAR(curve["mean"][1][0], 1, 1e-12);
    EXPECT_NEAR(curve["mean"][1][1], 4 * std::sqrt(1.005), 1e-5);
    EXPECT_EQ(curve["seeds"].size(), 2u);
}

TEST_F(ReportDataTest, ThePhotonPartHasCurvesSpeedupsAndRatiosOfItsOwn) {
    const Json group{{"scene", kPlainScene}, {"variant", "fixed"}, {"method", "better"},
                     {"part", "photons"},    {"clock", "cpu"},     {"metric", "relmse"}};
    const Json& curve = find(data_["curves"], group);
    EXPECT_NEAR(curve["mean"][1][1], 0.25 * 8 * 1.005, 1e-4);
    Json at_budget = group;
    at_budget["budget_s"] = 4.0;
    EXPECT_NEAR(find(data_["speedups"], at_budget)["speedup"], 4, 0.1);
    EXPECT_NEAR(find(data_["comparisons"], at_budget)["ratio"], 0.25, 0.01);
    at_budget["scene"] = kNastyScene;
    EXPECT_THROW(find(data_["comparisons"], at_budget), std::out_of_range);
}

TEST_F(ReportDataTest, SpeedupsAreThoseOfThePowerLawsOrBounds) {
    const auto speedup = [&](const char* method, double budget_s) {
        return find(data_["speedups"], {{"scene", kPlainScene},
                                        {"variant", "shipped"},
                                        {"method", method},
                                        {"part", "image"},
                                        {"clock", "wall"},
                                        {"metric", "mse"},
                                        {"budget_s", budget_s}});
    };
    EXPECT_NEAR(speedup("better", 4)["speedup"], 2, 0.02);
    EXPECT_TRUE(speedup("better", 4)["bound"].is_null());
    EXPECT_NEAR(speedup("worse", 1)["speedup"], 0.5, 0.005);
    EXPECT_EQ(speedup("worse", 4)["bound"], "at most");
    EXPECT_NEAR(speedup("worse", 4)["speedup"], 4 / 4.2, 1e-6);
}

TEST_F(ReportDataTest, PicturesOfAllMethodsWithOneExposureAndErrorScale) {
    ASSERT_EQ(data_["images"].size(), 2u);
    const Json& images = data_["images"][0];
    EXPECT_EQ(images["tiles"].size(), 6u);
    EXPECT_EQ(images["budget_s"], 4.0);
    EXPECT_NEAR(images["error_scale"], 0.2, 1e-9);  // "worse" is 20 % too dark
    EXPECT_TRUE(images["overview"].is_string());
    const Json& sppm = find(images["tiles"], {{"method", "sppm"}, {"variant", "fixed"}});
    EXPECT_EQ(sppm["image"], images["reference"]);
    EXPECT_NE(sppm["error"], find(images["tiles"], {{"method", "worse"}})["error"]);
}

TEST_F(ReportDataTest, WithoutReferencesPicturesHaveNoErrors) {
    ReferenceCache none(folder_.path() / "nowhere");
    const Json summary = read_json(folder_.path() / "study/summary.json");
    const Json data = report_data(folder_.path() / "study", summary, none);
    EXPECT_TRUE(data["images"][0]["reference"].is_null());
    EXPECT_TRUE(data["images"][0]["tiles"][0]["error"].is_null());
    EXPECT_TRUE(data["images"][0]["tiles"][0]["image"].is_string());
}

TEST_F(ReportDataTest, TheCommandWritesOneFile) {
    folder_.write("page.html", std::string("<p>") + kReportDataMark + "</p>");
    const BenchResult done =
        run_bench(folder_, "report study --page page.html --references references --out a/b.html");
    EXPECT_EQ(done.exit_code, 0) << done.text;
    const std::string html = read_file(folder_.path() / "a/b.html");
    EXPECT_EQ(Json::parse(html.substr(3, html.size() - 7))["images"], data_["images"]);
}

TEST_F(ReportDataTest, WhatIsMissingIsSaidOnce) {
    const BenchResult unbuilt = run_bench(folder_, "report study --page none.html");
    EXPECT_EQ(unbuilt.exit_code, 3);
    EXPECT_THAT(unbuilt.text, HasSubstr("'none.html' is not built; build the target "
                                        "bench-report-assets (it needs npm)"));
    folder_.write("page.html", kReportDataMark);
    const BenchResult nowhere = run_bench(folder_, "report nowhere --page page.html");
    EXPECT_EQ(nowhere.exit_code, 3);
    EXPECT_THAT(nowhere.text, HasSubstr("nowhere/summary.json"));
    folder_.write("study/summary.json", R"({"schema": "aips-bench-summary-1"})");
    const BenchResult damaged = run_bench(folder_, "report study --page page.html");
    EXPECT_EQ(damaged.exit_code, 3);
    EXPECT_THAT(damaged.text, HasSubstr("summary.json' is damaged"));
}

}  // namespace
}  // namespace bench::test::report_test
