// Protects that paper.json holds the experiments of the paper with their values, and what a scale
// does to them.
#include "experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "bench_process.h"
#include "experiment_plan.h"
#include "study_file.h"

namespace bench::test::experiment_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PaperTable paper() {
    return read_paper_table(BENCH_TABLES "/paper/paper.json");
}

Experiment experiment(const std::string& figure) {
    return choose_experiments(paper(), {figure}).at(0);
}

/// The values of "aips.PARAMETER=" among the cases with that guide, in their order.
std::vector<std::string> values(const Experiment& experiment, const std::string& parameter) {
    std::vector<std::string> found;
    const std::string key = "aips." + parameter + '=';
    for (const PaperCase& one : experiment.cases) {
        for (const std::string& text : one.set) {
            if (text.starts_with(key)) found.push_back(text.substr(key.size()));
        }
    }
    return found;
}

std::vector<std::string> labels(const Experiment& experiment) {
    std::vector<std::string> found;
    for (const PaperCase& one : experiment.cases)
        found.push_back(one.label);
    return found;
}

void expect_magic_lamp(const Experiment& experiment, std::uint64_t passes) {
    ASSERT_EQ(experiment.scenes.size(), 1u);
    EXPECT_EQ(experiment.scenes[0].name, "magic-lamp");
    EXPECT_EQ(experiment.width_px, 512u);
    EXPECT_EQ(experiment.height_px, 512u);
    EXPECT_EQ(experiment.passes, passes);
    EXPECT_EQ(experiment.part, "photons");  // the eye paths' noise is the same for all
}

TEST(PaperTable, Figure8VariesErroralpha) {
    const Experiment figure = experiment("8");
    expect_magic_lamp(figure, 40);
    EXPECT_THAT(values(figure, "erroralpha"), ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "0.95"));
    EXPECT_THAT(values(figure, "treedepth"), ElementsAre("64", "64", "64", "64", "64", "64"));
    EXPECT_THAT(labels(figure), Contains("unguided"));
}

TEST(PaperTable, Figure9VariesOneParameterEach) {
    for (const auto& [name, parameter] : std::vector<std::pair<const char*, const char*>>{
             {"9a", "treedepth"}, {"9b", "nodephotons"}, {"9c", "cdfresolution"}}) {
        const Experiment figure = experiment(name);
        expect_magic_lamp(figure, 64);
        const auto all = values(figure, parameter);
        EXPECT_GE(all.size(), 4u) << name;
        // The paper's own values are among them: depth 64, 32 photons, 8 x 8 cells.
        const auto own =
            std::find_if(figure.cases.begin(), figure.cases.end(),
                         [](const PaperCase& one) { return one.name == "aips-paper"; });
        ASSERT_NE(own, figure.cases.end()) << name;
        EXPECT_THAT(own->set,
                    ElementsAre("aips.debuglayers=true", "aips.erroralpha=0.4", "aips.treedepth=64",
                                "aips.nodephotons=32", "aips.cdfresolution=8"));
    }
    EXPECT_THAT(values(experiment("9a"), "treedepth"), ElementsAre("4", "8", "16", "32", "64"));
}

TEST(PaperTable, Figure9dComparesWithTraditionalPhotonMapping) {
    const Experiment figure = experiment("9d");
    expect_magic_lamp(figure, 64);
    EXPECT_EQ(figure.kind, ExperimentKind::Convergence);
    EXPECT_EQ(figure.cases[0].method, "exphotonmap");
    EXPECT_EQ(figure.cases[1].against, "exphotonmap");
    EXPECT_EQ(figure.cases[3].method, "aips-paper");
    EXPECT_EQ(figure.cases[3].against, "sppm");
}

TEST(PaperTable, Figures6And7AndTheirDebugLayers) {
    const Experiment figure = experiment("6-7");
    EXPECT_EQ(figure.scenes[0].name, "glass-ball");
    EXPECT_EQ(figure.width_px, 600u);
    EXPECT_EQ(figure.passes, 40u);
    EXPECT_THAT(figure.cases[0].set, Contains("sppm.debuglayers=true"));
    EXPECT_THAT(figure.cases[1].set, Contains("aips.debuglayers=true"));
    EXPECT_EQ(paper().photons_per_pass, 100'000u);
}

TEST(PaperTable, Figure10AtEqualTime) {
    const Experiment figure = experiment("10");
    EXPECT_EQ(figure.width_px, 1024u);
    ASSERT_EQ(figure.scenes.size(), 3u);
    EXPECT_EQ(figure.scenes[0].name, "chess");
    EXPECT_EQ(figure.scenes[1].name, "room");
    EXPECT_EQ(figure.scenes[2].name, "summerhouse");
    // The paper's 2, 4 and 8 hours, in proportion.
    EXPECT_EQ(figure.scenes[1].seconds, 2 * figure.scenes[0].seconds);
    EXPECT_EQ(figure.scenes[2].seconds, 4 * figure.scenes[0].seconds);
    EXPECT_THAT(labels(figure), ElementsAre("Monte Carlo", "Metropolis", "PPM", "AIPS in PPM",
                                            "PPM (stochastic)", "AIPS"));
    EXPECT_THAT(figure.cases[1].set, ElementsAre("metropolis.maxconsecrejects=0"));
}

TEST(PaperTable, FiguresAreChosenByTheirBeginning) {
    EXPECT_EQ(choose_experiments(paper(), {}).size(), 7u);
    EXPECT_EQ(choose_experiments(paper(), {"9", "8"}).size(), 5u);
    EXPECT_THROW(choose_experiments(paper(), {"11"}), StudyError);
}

TEST(PaperTable, ScaleShrinksSizePassesAndSecondsTogether) {
    const Experiment by_passes = scaled(experiment("8"), 0.25);
    EXPECT_EQ(by_passes.width_px, 128u);
    EXPECT_EQ(by_passes.height_px, 128u);
    EXPECT_EQ(by_passes.passes, 10u);
    const Experiment by_time = scaled(experiment("10"), 0.25);
    EXPECT_EQ(by_time.passes, 0u);
    EXPECT_EQ(by_time.scenes[0].seconds, experiment("10").scenes[0].seconds / 4);
    const Experiment least = scaled(experiment("8"), 1e-9);
    EXPECT_EQ(least.width_px, 8u);
    EXPECT_EQ(least.passes, 2u);
}

TEST(PaperTable, AVariedParameterHasToBeTheGuides) {
    const TemporaryFolder folder;
    std::string text = read_file(BENCH_TABLES "/paper/paper.json");
    const std::string parameter = R"("parameter": "erroralpha")";
    ASSERT_NE(text.find(parameter), std::string::npos);
    text.replace(text.find(parameter), parameter.size(), R"("parameter": "erroralfa")");
    folder.write("paper.json", text);
    try {
        read_paper_table(folder.path() / "paper.json");
        FAIL() << "accepted";
    } catch (const StudyError& error) {
        EXPECT_THAT(error.what(), HasSubstr("\"erroralfa\" is no parameter of \"guide\""));
    }
}

class PaperPlanTest : public testing::Test {
  protected:
    static std::vector<RunSettings> plan(const std::string& figure, unsigned seeds) {
        const Experiment found = experiment(figure);
        std::vector<BenchScene> scenes;
        for (const PaperScene& scene : found.scenes)
            scenes.push_back(find_scene(scene.name, BENCH_TABLES "/scenes.json", BENCH_SCENES));
        MethodTable methods = read_method_table(BENCH_TABLES "/methods.json");
        methods.photons_per_pass = paper().photons_per_pass;
        return plan_experiment(found, scenes, methods, seeds, 2);
    }
};

TEST_F(PaperPlanTest, RunsByPasses) {
    const auto runs = plan("8", 2);
    ASSERT_EQ(runs.size(), 14u);  // 7 cases x 2 seeds
    EXPECT_EQ(run_name(runs[0]), "magic-lamp.aips-paper-erroralpha-0.shipped.s1");
    EXPECT_EQ(run_name(runs[2]), "magic-lamp.aips-paper.shipped.s1");
    EXPECT_EQ(run_name(runs[13]), "magic-lamp.sppm.shipped.s2");
    EXPECT_THAT(runs[0].passes, ElementsAre(1, 2, 4, 8, 16, 32, 40));
    EXPECT_TRUE(runs[0].budgets_s.empty());
    EXPECT_THAT(runs[0].set,
                ElementsAre("aips.photonperpass=100000", "aips.guide=paper",
                            "aips.debuglayers=true", "aips.erroralpha=0", "aips.treedepth=64",
                            "aips.nodephotons=32", "aips.cdfresolution=8"));
    EXPECT_EQ(to_json(run_settings_from(to_json(runs[0]))), to_json(runs[0]));
}

TEST_F(PaperPlanTest, FiguresOfOneStudyShareTheRunAtThePapersValues) {
    const auto is_own = [](const RunSettings& run) { return run.method == "aips-paper"; };
    const auto a = plan("9a", 1), b = plan("9b", 1), d = plan("9d", 1);
    const Json own = to_json(*std::find_if(a.begin(), a.end(), is_own));
    EXPECT_EQ(to_json(*std::find_if(b.begin(), b.end(), is_own)), own);
    EXPECT_EQ(to_json(*std::find_if(d.begin(), d.end(), is_own)), own);
}

TEST_F(PaperPlanTest, RunsByTime) {
    const auto runs = plan("10", 1);
    ASSERT_EQ(runs.size(), 18u);  // 3 scenes x 6 cases
    EXPECT_EQ(run_name(runs[0]), "chess.path.any.s1");
    EXPECT_EQ(runs[1].sampler, "metropolis");
    EXPECT_THAT(runs[0].budgets_s, ElementsAre(5, 10, 20));
    EXPECT_TRUE(runs[0].passes.empty());
    EXPECT_THAT(runs[3].set, Contains("aips.mode=ppm"));
    EXPECT_THAT(runs[5].set, Not(Contains("aips.mode=ppm")));
}

}  // namespace
}  // namespace bench::test::experiment_test
