// Protects the figures of the tables: errors at equal passes, and at the time that all runs reach.
#include "experiment_errors.h"

#include <gtest/gtest.h>

#include "paper_text.h"

namespace bench::test::experiment_errors_test {
namespace {

/// A run whose MSE is scale / pass; a pass takes `pass_s` seconds.
Json run_of(const std::string& name, unsigned seed, double scale, double pass_s) {
    Json snapshots = Json::array();
    for (const int pass : {1, 2, 4}) {
        snapshots.push_back(
            {{"pass", pass},
             {"cpu_s", pass * pass_s},
             {"error",
              {{"image",
                {{"mse", scale / pass},
                 {"relmse", 10 * scale / pass},
                 {"relmse_rest", scale / pass}}},
               {"photons", {{"mse", 3 * scale / pass}, {"relmse", 1.0}, {"relmse_rest", 1.0}}}}}});
    }
    return {{"status", "done"},
            {"settings", {{"scene", "s"}, {"method", name}, {"seed", seed}}},
            {"totals", {{"passes", 4}}},
            {"phases", {{"render_cpu_s", 4 * pass_s}}},
            {"peak_memory_bytes", 1 << 20},
            {"integrator_statistics", {{"guide_bytes", 512}}},
            {"snapshots", snapshots}};
}

Experiment two_cases() {
    Experiment experiment;
    experiment.figure = "8";
    experiment.title = "test";
    experiment.scenes = {{"s", 0}};
    experiment.passes = 4;
    experiment.cases = {{"slow", "slow", "", {}, "plain"}, {"plain", "plain", "", {}, "plain"}};
    return experiment;
}

Json two_seeds() {
    return Json::array({run_of("slow", 1, 2, 2), run_of("plain", 1, 4, 1), run_of("slow", 2, 4, 2),
                        run_of("plain", 2, 8, 1)});
}

TEST(ExperimentErrors, BetterAtEqualPassesAndEvenAtEqualTime) {
    const Json scene = experiment_errors(two_cases(), two_seeds(), 2).at(0);
    EXPECT_EQ(scene["equal_time_s"], 4);  // where the faster one ends
    const Json& slow = scene["rows"][0];
    EXPECT_DOUBLE_EQ(slow["equal_passes"]["mse"]["mean"], 0.75);  // of 2/4 and 4/4
    EXPECT_DOUBLE_EQ(slow["equal_passes"]["mse"]["ratio"], 0.5);
    EXPECT_NEAR(slow["equal_passes"]["relmse"]["low"], 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(slow["equal_time"]["mse"]["ratio"], 1);  // two passes against four
    EXPECT_EQ(slow["equal_time"]["mse"]["seeds"], 2);
    EXPECT_EQ(slow["cpu_s"], 8);
    EXPECT_EQ(slow["guide_bytes"], 512);
    EXPECT_EQ(slow["curve"][1]["pass"], 2);
    EXPECT_DOUBLE_EQ(slow["curve"][1]["mse"], 1.5);
}

TEST(ExperimentErrors, AFailedRunIsLeftOutAndSaidToBe) {
    Json runs = two_seeds();
    runs[2]["status"] = "failed";
    const Json scene = experiment_errors(two_cases(), runs, 2).at(0);
    const Json& mse = scene["rows"][0]["equal_passes"]["mse"];
    EXPECT_EQ(mse["seeds"], 1);
    EXPECT_EQ(mse["left_out"], 1);
    EXPECT_DOUBLE_EQ(mse["mean"], 0.5);
    EXPECT_TRUE(mse["low"].is_null());
}

TEST(ExperimentErrors, OfThePhotonsPartAlone) {
    Experiment experiment = two_cases();
    experiment.part = "photons";
    const Json scene = experiment_errors(experiment, two_seeds(), 2).at(0);
    EXPECT_DOUBLE_EQ(scene["rows"][0]["equal_passes"]["mse"]["mean"], 2.25);
}

TEST(ExperimentErrors, ByTimeTheBudgetIsTheTime) {
    Experiment experiment = two_cases();
    experiment.passes = 0;
    experiment.scenes[0].seconds = 3;
    const Json scene = experiment_errors(experiment, two_seeds(), 2).at(0);
    EXPECT_EQ(scene["equal_time_s"], 3);
    EXPECT_TRUE(scene["rows"][0]["equal_passes"].is_null());
    // mse goes with 1/time between snapshots too: (2 / (3/2)) / (4 / 3).
    EXPECT_NEAR(scene["rows"][0]["equal_time"]["mse"]["ratio"], 1, 1e-12);
}

TEST(PaperText, OneTableForAFigure) {
    Json scenes = experiment_errors(two_cases(), two_seeds(), 2);
    for (Json& row : scenes[0]["rows"]) {
        row["relative_variance"] = 0.25;
        row["variance_ratio"] = nullptr;
    }
    const Json paper{{"scale", 0.5},
                     {"seeds", 2},
                     {"photons_per_pass", 1000},
                     {"reference_seconds", 3},
                     {"machine", {{"processor", "P"}}},
                     {"revision", "r"},
                     {"created", "now"},
                     {"experiments", Json::array({{{"figure", "8"},
                                                   {"title", "test"},
                                                   {"kind", "passes"},
                                                   {"width_px", 4},
                                                   {"height_px", 2},
                                                   {"part", "image"},
                                                   {"passes", 4},
                                                   {"scenes", scenes},
                                                   {"distribution", Json::array()}}})}};
    const std::string text = paper_text(paper);
    EXPECT_NE(text.find("## Fig. 8: test\n"), std::string::npos) << text;
    EXPECT_NE(text.find("s, 4 x 2 pixels, whole image, after 4 passes."), std::string::npos)
        << text;
    EXPECT_NE(text.find("| slow | 0.75 | 7.5 | 0.75 | 0.5 [0.5, 0.5] | 0.5 [0.5, 0.5] | 0.5 [0.5, "
                        "0.5] | 0.25 | - | plain |\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("| MSE ratio at 4.0 CPU s |"), std::string::npos) << text;
    EXPECT_NE(text.find("| slow | 8.0 | 1 [1, 1] | 1 [1, 1] | 1 [1, 1] | - | 0.0 | 1.0 |\n"),
              std::string::npos)
        << text;
}

}  // namespace
}  // namespace bench::test::experiment_errors_test
