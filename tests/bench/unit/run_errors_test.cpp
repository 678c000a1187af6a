// Protects the figures in a run's document: errors of its snapshots, at its budgets, and again when
// the references have changed.
#include "run_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench_process.h"
#include "comparison.h"
#include "image_file.h"
#include "study_file.h"
#include "synthetic_image.h"

namespace bench::test::run_errors_test {
namespace {

Image constant(double value) {
    return synthetic_image(8, 8, [=](int, int) { return value; });
}

class RunErrorsTest : public testing::Test {
  protected:
    /// A run of `method` whose error of the image falls as scale / t: snapshots at 1, 2.5 and 5 s.
    Json run(const std::string& method, int seed, double scale, bool photons) {
        Json json{{"status", "done"},
                  {"settings",
                   {{"scene", "s"},
                    {"scene_sha1", "x"},
                    {"width_px", 0},
                    {"method", method},
                    {"variant", "fixed"},
                    {"seed", seed},
                    {"budgets_s", {2, 4}}}},
                  {"references", nullptr},
                  {"at_budget", Json::array()},
                  {"snapshots", Json::array()}};
        const std::array<std::pair<double, Json>, 3> times{
            {{1, Json::array()}, {2.5, mark(2)}, {5, mark(4)}}};
        for (const auto& [time, marks] : times) {
            const std::string file =
                method + std::to_string(seed) + std::to_string(int(2 * time)) + ".exr";
            const Image image = constant(1 + std::sqrt(scale / time));
            std::vector<NamedLayer> layers{{"", image}};
            if (photons) layers.push_back({kPhotonLayer, image});
            write_layers(folder_.path() / file, layers);
            json["snapshots"].push_back(
                {{"cpu_s", time}, {"wall_s", time / 2}, {"marks", marks}, {"exr", file}});
        }
        return json;
    }

    static Json mark(double seconds) {
        return Json::array({{{"clock", "cpu"}, {"seconds", seconds}}});
    }

    References references(bool photons, const std::string& sum = "a") {
        References found;
        found.metadata["images"] = {{"1", {{"sha1", sum}}}, {"2", {{"sha1", "b"}}}};
        found.image = {constant(1), constant(1)};
        if (photons) found.photons = ReferencePair{constant(1), constant(1)};
        return found;
    }

    TemporaryFolder folder_;
};

TEST_F(RunErrorsTest, ErrorsAreInterpolatedToTheBudgets) {
    Json json = run("a", 1, 0.1, false);
    const References found = references(false);
    EXPECT_TRUE(measure_run(folder_.path(), &found, json));
    ASSERT_EQ(json["at_budget"].size(), 2u);
    const Json& at = json["at_budget"][1];
    EXPECT_EQ(at["budget_s"], 4);
    EXPECT_EQ(at["clock"], "cpu");
    EXPECT_EQ(at["snapshot"], 2);
    EXPECT_NEAR(at["image"]["mse"], 0.1 / 4, 1e-6);
    EXPECT_NEAR(at["image"]["efficiency_mse"], 1 / 0.1, 1e-3);
    EXPECT_TRUE(at["photons"].is_null());
    EXPECT_NEAR(json["snapshots"][0]["error"]["image"]["mse"], 0.1, 1e-6);
}

TEST_F(RunErrorsTest, PhotonPartCountsOnlyWhereAllHaveIt) {
    Json with = run("a", 1, 0.1, true);
    const References both = references(true), image_alone = references(false, "other");
    measure_run(folder_.path(), &both, with);
    EXPECT_NEAR(with["at_budget"][0]["photons"]["mse"], 0.05, 1e-6);
    measure_run(folder_.path(), &image_alone, with);
    EXPECT_TRUE(with["at_budget"][0]["photons"].is_null());
}

TEST_F(RunErrorsTest, MeasuresAgainOnlyWhenReferencesChange) {
    Json json = run("a", 1, 0.1, false);
    const References first = references(false), changed = references(false, "c");
    EXPECT_TRUE(measure_run(folder_.path(), &first, json));
    EXPECT_FALSE(measure_run(folder_.path(), &first, json));
    EXPECT_TRUE(measure_run(folder_.path(), &changed, json));
    EXPECT_TRUE(measure_run(folder_.path(), nullptr, json));
    EXPECT_TRUE(json["references"].is_null());
    EXPECT_TRUE(json["at_budget"][0]["image"].is_null());
}

TEST_F(RunErrorsTest, ComparisonsAreRatiosToTheBaselineAtEqualTime) {
    Json runs = Json::array();
    const References found = references(false);
    for (int seed = 1; seed <= 3; ++seed) {
        for (const auto& [method, scale] : {std::pair{"sppm", 0.4}, std::pair{"better", 0.1}}) {
            runs.push_back(run(method, seed, scale, false));
            measure_run(folder_.path(), &found, runs.back());
        }
    }
    const Json study{{"scenes", {"s"}},    {"variants", {"fixed"}}, {"methods", {"sppm", "better"}},
                     {"seeds", {1, 2, 3}}, {"budgets_s", {2, 4}},   {"clock", "cpu"},
                     {"baseline", "sppm"}};
    const Json list = compare_methods(runs, study);
    ASSERT_EQ(list.size(), 2u * 2 * 3);
    const Json& last = list.back();
    EXPECT_EQ(last["method"], "better");
    EXPECT_EQ(last["seeds"], 3);
    EXPECT_NEAR(last["ratio"], 0.25, 1e-4);
    EXPECT_NEAR(last["efficiency_ratio"], 4, 1e-3);
    EXPECT_LE(last["low"], last["ratio"]);
}

}  // namespace
}  // namespace bench::test::run_errors_test
