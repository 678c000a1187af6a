// Protects `aips-bench paper` as a whole, in its smallest form and for function only: references,
// runs by passes and by time, tables, pictures, resumption. No time is tested.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "study_file.h"

namespace bench::test::smallest_paper_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kTable = R"({
  "photons_per_pass": 500,
  "guide": {"methods": ["aips-paper"],
            "set": {"erroralpha": 0.4, "treedepth": 64, "nodephotons": 32, "cdfresolution": 8}},
  "experiments": [
    {"figure": "6", "kind": "distribution", "study": "layers", "title": "where",
     "scenes": [{"name": "cornell-box"}], "width_px": 24, "height_px": 16, "passes": 4,
     "baseline": "sppm", "cases": [
       {"name": "sppm", "label": "unguided", "method": "sppm", "set": ["sppm.debuglayers=true"]},
       {"name": "aips-paper", "label": "guided", "method": "aips-paper",
        "set": ["aips.debuglayers=true"]}]},
    {"figure": "9", "kind": "convergence", "study": "passes", "title": "how fast",
     "scenes": [{"name": "cornell-box"}], "width_px": 24, "height_px": 16, "passes": 6,
     "baseline": "aips-paper",
     "vary": {"case": "aips-paper", "parameter": "erroralpha", "values": [0, 0.4]},
     "cases": [{"name": "aips-paper", "label": "guided", "method": "aips-paper"}]},
    {"figure": "10", "kind": "time", "study": "time", "title": "equal time",
     "scenes": [{"name": "cornell-box", "seconds": 0.2}], "width_px": 24, "height_px": 16,
     "baseline": "path", "cases": [
       {"name": "path", "label": "Monte Carlo", "method": "path"},
       {"name": "metropolis", "label": "Metropolis", "method": "metropolis",
        "set": ["metropolis.maxconsecrejects=0"]}]}]})";

constexpr const char* kPaper =
    "paper --paper-table table.json --scale 0.5 --seeds 2 --threads 1 --reference-seconds 0.8 "
    "--out study";

class SmallestPaperTest : public testing::Test {
  protected:
    SmallestPaperTest() { folder_.write("table.json", kTable); }
    BenchResult run(const std::string& arguments) { return run_bench(folder_, arguments); }
    std::string text_of(const char* name) const { return read_file(folder_.path() / name); }
    TemporaryFolder folder_;
};

TEST_F(SmallestPaperTest, TablesPicturesAndResumption) {
    const BenchResult first = run(kPaper);
    ASSERT_EQ(first.exit_code, 0) << first.text;
    const Json paper = read_json(folder_.path() / "study/paper.json");
    EXPECT_EQ(paper["schema"], "aips-bench-paper-1");
    ASSERT_EQ(paper["experiments"].size(), 3u);
    for (const char* heading : {"## Fig. 6: where", "## Fig. 9: how fast", "## Fig. 10: equal"})
        EXPECT_THAT(text_of("study/paper.md"), HasSubstr(heading));
    EXPECT_THAT(first.text, HasSubstr(text_of("study/paper.md")));

    // By passes: half of six, with snapshots after 1, 2 and 3.
    const Json by_passes =
        read_json(folder_.path() / "study/passes/runs/cornell-box.aips-paper.shipped.s1.json");
    EXPECT_EQ(by_passes["totals"]["passes"], 3);
    EXPECT_EQ(by_passes["snapshots"].size(), 3u);
    EXPECT_EQ(by_passes["image"]["width_px"], 12);
    EXPECT_EQ(by_passes["image"]["height_px"], 8);
    EXPECT_TRUE(by_passes["snapshots"][2]["error"]["image"]["mse"].is_number());
    const Json& rows = paper["experiments"][1]["scenes"][0]["rows"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["case"], "aips-paper-erroralpha-0");
    EXPECT_TRUE(rows[0]["equal_passes"]["mse"]["mean"].is_number());
    EXPECT_GT(rows[0]["guide_bytes"], 0);
    EXPECT_GT(rows[0]["relative_variance"], 0);
    EXPECT_EQ(rows[1]["variance_ratio"], 1);  // against itself

    // By time: at least the budget.
    const Json by_time = read_json(folder_.path() / "study/time/runs/cornell-box.path.any.s1.json");
    EXPECT_GE(by_time["snapshots"].back()["cpu_s"], 0.1);
    EXPECT_THAT(text_of("study/time/logs/cornell-box.metropolis.any.s1.log"),
                HasSubstr("maxconsecrejects 0"));

    const Json& stages = paper["experiments"][0]["distribution"][0]["rows"][1]["stages"];
    EXPECT_EQ(stages.back()["last_pass"], 2);
    EXPECT_TRUE(stages.back()["distance"].is_number());
    EXPECT_TRUE(fs::exists(folder_.path() / "study/images/cornell-box.aips-paper.passes-2-2.png"));

    // Nothing is repeated.
    const char* file = "study/passes/runs/cornell-box.aips-paper.shipped.s2.json";
    const std::string before = text_of(file);
    ASSERT_EQ(run(kPaper).exit_code, 0);
    EXPECT_EQ(text_of(file), before);
}

TEST_F(SmallestPaperTest, UnknownFigureAndScaleAreRefused) {
    const BenchResult figure = run(std::string(kPaper) + " --figures 11");
    EXPECT_EQ(figure.exit_code, 3);
    EXPECT_THAT(figure.text, HasSubstr("unknown figure \"11\"; known: 6, 9, 10"));
    EXPECT_EQ(run("paper --out study --scale 0").exit_code, 2);
    EXPECT_EQ(run("paper --out study --scale 1.5").exit_code, 2);
}

}  // namespace
}  // namespace bench::test::smallest_paper_test
