// Protects the whole command, in its smallest form and for function only: references that grow, a
// study, its resumption, failure of a run, the table. No time is tested.
#include <cstdint>

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "image_file.h"
#include "study_file.h"

namespace bench::test::smallest_study_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// By CPU time, as the study: chunks of a pass or two, as a busy machine makes them, have no spread
// that two references could be compared by.
const std::string kReference =
    "reference --scenes furnace --width 12 --threads 1 --clock cpu --seconds ";
constexpr const char* kRun =
    "run --scenes furnace --methods path,sppm --width 12 --threads 1 --seeds 2 "
    "--budgets 0.05,0.1 --clock cpu --variants fixed --photons-per-pass 500 --out study";

class SmallestStudyTest : public testing::Test {
  protected:
    BenchResult run(const std::string& arguments) { return run_bench(folder_, arguments); }
    Json summary() const { return read_json(folder_.path() / "study/summary.json"); }
    Json reference() const {
        return read_json(folder_.path() / "out/bench-references/furnace-w12/reference.json");
    }
    std::string text_of_run(const char* name) const {
        return read_file(folder_.path() / "study/runs" / name);
    }
    TemporaryFolder folder_;
};

/// Every key that docs/reference/benchmark-files.md promises.
void expect_documented_run(const Json& run) {
    for (const char* key :
         {"schema", "status", "revision", "binaries_sha1", "settings", "machine", "started",
          "image", "phases", "totals", "peak_memory_bytes", "refused_film_samples",
          "integrator_statistics", "trace", "snapshots", "references", "at_budget", "file"}) {
        EXPECT_TRUE(run.contains(key)) << key;
    }
    for (const char* key :
         {"load_s", "build_s", "prepare_s", "render_wall_s", "render_cpu_s", "snapshots_s"}) {
        EXPECT_GE(run["phases"].at(key), 0.0) << key;
    }
    for (const char* key : {"pass", "wall_s", "cpu_s", "photon_paths", "rays", "resident_bytes"}) {
        EXPECT_TRUE(run["trace"][0].contains(key)) << key;
        EXPECT_TRUE(run["snapshots"][0].contains(key)) << key;
    }
    EXPECT_GT(run["peak_memory_bytes"], 1'000'000);
    EXPECT_GE(run["phases"]["render_cpu_s"], 0.1);
    EXPECT_GE(run["snapshots"].back()["cpu_s"], 0.1);
}

TEST_F(SmallestStudyTest, ReferencesStudyResumptionAndTable) {
    ASSERT_EQ(run(kReference + "0.8").exit_code, 0);
    const BenchResult first = run(kRun);
    ASSERT_EQ(first.exit_code, 0) << first.text;

    const Json found = summary();
    EXPECT_EQ(found["schema"], "aips-bench-summary-1");
    ASSERT_EQ(found["runs"].size(), 4u);  // path, sppm, path, sppm
    EXPECT_EQ(found["runs"][0]["settings"]["method"], "path");
    EXPECT_EQ(found["runs"][1]["settings"]["method"], "sppm");
    EXPECT_EQ(found["runs"][2]["settings"]["seed"], 2);
    for (const Json& run : found["runs"]) {
        expect_documented_run(run);
        for (const Json& snapshot : run["snapshots"]) {
            EXPECT_TRUE(fs::exists(folder_.path() / "study" / snapshot["exr"].get<std::string>()));
            EXPECT_EQ(snapshot["png"].is_string(), run["settings"]["seed"] == 1);
            EXPECT_TRUE(snapshot["error"]["image"]["relmse"].is_number());
        }
        EXPECT_EQ(run["at_budget"].size(), 2u);
    }
    EXPECT_EQ(found["seed_statistics"].size(), 4u);  // 2 methods x 2 budgets
    EXPECT_EQ(found["scenes"][0]["reference"]["scene"], "furnace");
    EXPECT_FALSE(found["comparisons"].empty());

    // Nothing is repeated: the runs' files stay as they are.
    const std::string before = text_of_run("furnace.sppm.fixed.s1.json");
    ASSERT_EQ(run(kRun).exit_code, 0);
    EXPECT_EQ(text_of_run("furnace.sppm.fixed.s1.json"), before);
    // Another setting is another run.
    ASSERT_EQ(run(std::string(kRun) + " --set sppm.maxeyedepth=5").exit_code, 0);
    EXPECT_NE(text_of_run("furnace.sppm.fixed.s1.json"), before);

    const BenchResult table = run("table study");
    EXPECT_EQ(table.exit_code, 0);
    EXPECT_THAT(table.text, HasSubstr("## furnace: one fixed radius for all"));
    EXPECT_THAT(table.text, HasSubstr("| sppm | 0.1 |"));
}

/// Renders with as many passes as `measured` had, as a user would, and compares the images.
void expect_users_image(const TemporaryFolder& folder, const Json& measured) {
    const Json& settings = measured["settings"];
    std::string command = fmt::format(
        "'{}' '{}/prism.lxs' --integrator {} --width 24 --threads 1 --seed 1 --passes {} -o "
        "user.exr",
        LXSRENDER, BENCH_SCENES, settings["integrator"].get<std::string>(),
        measured["totals"]["passes"].get<std::uint64_t>());
    for (const Json& set : settings["set"])
        command += " --set " + set.get<std::string>();
    const BenchResult render = run_program(folder, command);
    ASSERT_EQ(render.exit_code, 0) << render.text;
    const fs::path last = measured["snapshots"].back()["exr"].get<std::string>();
    const Image users = read_image(folder.path() / "user.exr");
    const auto difference =
        OIIO::ImageBufAlgo::compare(read_image(folder.path() / "study" / last), users, 0, 0);
    EXPECT_EQ(difference.maxerror, 0) << command;
    EXPECT_GT(mean_luminance(users), 0);
}

/// A render that is measured is the one that a user gets, pass by pass: wavelengths of a scene that
/// disperses light were once those of the first pass in all of a study's passes.
TEST_F(SmallestStudyTest, RendersWhatAUserGets) {
    // Seven times what the first pass of aips takes: there has to be a second on any machine.
    const BenchResult study =
        run("run --scenes prism --methods path,aips --width 24 --threads 1 --seeds 1 "
            "--budgets 1 --clock cpu --variants shipped --photons-per-pass 500 --out study");
    ASSERT_EQ(study.exit_code, 0) << study.text;
    const Json found = summary();
    ASSERT_EQ(found["runs"].size(), 2u);
    for (const Json& measured : found["runs"]) {
        EXPECT_GT(measured["totals"]["passes"], 1u);
        expect_users_image(folder_, measured);
    }
}

/// Every key that docs/reference/benchmark-files.md promises.
void expect_documented_test(const Json& test) {
    for (const char* key :
         {"scene", "variant", "method", "against", "seeds", "mean_ratio", "claimed_bias",
          "weighted_ratio", "weighted_low", "weighted_high", "standard_error", "smallest_p",
          "threshold", "smallest_at", "detectable", "detectable_in_block", "misses", "verdict"}) {
        EXPECT_TRUE(test.contains(key)) << key;
    }
    EXPECT_EQ(test["seeds"], 3);
    EXPECT_LT(test["weighted_low"], test["weighted_ratio"]);
    EXPECT_GT(test["weighted_high"], test["weighted_ratio"]);
}

TEST_F(SmallestStudyTest, AgreementOfMethods) {
    const std::string study =
        "run --scenes furnace --methods path,sppm,aips-none --width 12 --threads 1 --seeds 3 "
        "--budgets 0.05 --clock cpu --variants fixed --photons-per-pass 500 --out ";
    ASSERT_EQ(run(study + "study").exit_code, 0);
    const BenchResult without = run("agreement study");
    EXPECT_EQ(without.exit_code, 3);
    EXPECT_THAT(without.text, HasSubstr("\"furnace\" has no references"));

    ASSERT_EQ(run(kReference + "1.6").exit_code, 0);
    ASSERT_EQ(run("agreement study").exit_code, 0);
    const Json bare = read_json(folder_.path() / "study/agreement.json");
    EXPECT_TRUE(bare["tests"][1]["claimed_bias"].is_null());

    // A study at the same radius tells nothing; one at half of it does.
    const BenchResult same = run("agreement study --smaller-radius study");
    EXPECT_EQ(same.exit_code, 3);
    EXPECT_THAT(same.text, HasSubstr("at a fixed radius below 2"));
    ASSERT_EQ(run(study + "half --set sppm.startradius=1").exit_code, 0);
    const BenchResult found = run("agreement study --smaller-radius half");
    EXPECT_EQ(found.exit_code, 0) << found.text;
    EXPECT_THAT(found.text, HasSubstr("## furnace: agreement at one fixed radius"));
    const Json tests = read_json(folder_.path() / "study/agreement.json").at("tests");
    // path, sppm and aips-none against the references; aips-none against sppm.
    ASSERT_EQ(tests.size(), 4u);
    for (const Json& test : tests)
        expect_documented_test(test);
    EXPECT_TRUE(tests[0]["claimed_bias"].is_null());
    EXPECT_TRUE(tests[1]["claimed_bias"].is_number());
    EXPECT_EQ(tests[3]["against"], "sppm");

    // A scene table that says that path misses light: no agreement, whatever the images say.
    folder_.write("scenes.json", R"({"scenes": [{"name": "furnace", "misses": {"path": "much"},
                                     "references": ["path", "photons"]}]})");
    EXPECT_THAT(run("agreement study --scene-table scenes.json").text,
                HasSubstr("does not converge: misses much"));
}

TEST_F(SmallestStudyTest, AShrinkingRadiusHasNoAgreement) {
    ASSERT_EQ(run(kReference + "0.8").exit_code, 0);
    ASSERT_EQ(run("run --scenes furnace --methods sppm --width 12 --threads 1 --seeds 1 --budgets "
                  "0.02 --clock cpu --variants shipped --photons-per-pass 500 --out study")
                  .exit_code,
              0);
    const BenchResult result = run("agreement study");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.text, HasSubstr("has no variant \"fixed\""));
}

TEST_F(SmallestStudyTest, ReferencesGrowAndErrorsFollowThemWithoutNewRenders) {
    const std::string run_alone =
        "run --scenes furnace --methods sppm --width 12 --threads 1 --seeds 1 --budgets 0.05 "
        "--clock cpu --variants fixed --photons-per-pass 500 --out study";
    const BenchResult without = run(run_alone);
    ASSERT_EQ(without.exit_code, 0) << without.text;
    EXPECT_THAT(without.text, HasSubstr("has no references"));
    const Json unmeasured = summary()["runs"][0];
    EXPECT_TRUE(unmeasured["at_budget"][0]["image"].is_null());

    ASSERT_EQ(run(kReference + "0.8").exit_code, 0);
    const Json two = reference();
    ASSERT_EQ(run(kReference + "1.6 --up-to").exit_code, 0);
    const Json more = reference();
    for (const char* name : {"1", "2"}) {
        EXPECT_GT(more["images"][name]["weight"], two["images"][name]["weight"]);
        EXPECT_GT(more["images"][name]["chunks"].size(), two["images"][name]["chunks"].size());
        EXPECT_EQ(more["images"][name]["chunks"][0], two["images"][name]["chunks"][0]);
    }
    EXPECT_EQ(more["images"]["1"]["method"], "path");
    EXPECT_EQ(more["images"]["2"]["method"], "photons");

    ASSERT_EQ(run(run_alone).exit_code, 0);
    const Json measured = summary()["runs"][0];
    EXPECT_EQ(measured["started"], unmeasured["started"]);  // the same render
    EXPECT_EQ(measured["references"]["1"], more["images"]["1"]["sha1"]);
    EXPECT_FALSE(measured["snapshots"].back()["error"]["image"].is_null());
}

TEST_F(SmallestStudyTest, DamagedReferencesAndOtherScenesAreRefused) {
    folder_.write("own.lxs", read_file(std::string(BENCH_SCENES) + "/furnace.lxs"));
    const std::string reference_own =
        "reference --scenes own.lxs --width 12 --threads 1 --seconds 0.6";
    ASSERT_EQ(run(reference_own).exit_code, 0);
    const fs::path references = folder_.path() / "out/bench-references/own-w12";
    const Json metadata = read_json(references / "reference.json");
    // A scene without entry in the table gets photons by two methods, and the halved radius.
    EXPECT_TRUE(metadata["images"].contains("halved"));
    EXPECT_TRUE(metadata["bias_left"].contains("relmse"));

    folder_.write("own.lxs", read_file(folder_.path() / "own.lxs") + "# changed\n");
    const BenchResult changed = run(reference_own);
    EXPECT_EQ(changed.exit_code, 3);
    EXPECT_THAT(changed.text, HasSubstr("of another version of scene \"own\""));

    folder_.write("own.lxs", read_file(std::string(BENCH_SCENES) + "/furnace.lxs"));
    const std::string file = metadata["images"]["1"]["file"];
    folder_.write("out/bench-references/own-w12/" + file, "damage");
    const BenchResult damaged = run(reference_own);
    EXPECT_EQ(damaged.exit_code, 3);
    EXPECT_THAT(damaged.text, HasSubstr("its SHA-1 is not the one in reference.json"));
}

TEST_F(SmallestStudyTest, AFailedRunDoesNotEndTheStudy) {
    // A scene that is read but can't be rendered: the file vanishes behind an Include.
    folder_.write("broken.lxs", "Include \"missing.lxm\"\nWorldBegin\nWorldEnd\n");
    const BenchResult result =
        run("run --scenes broken.lxs,furnace --methods path --baseline path --width 8 --threads 1 "
            "--seeds 1 --budgets 0.02 --clock cpu --out study");
    EXPECT_EQ(result.exit_code, 6) << result.text;
    const Json found = summary();
    ASSERT_EQ(found["runs"].size(), 2u);
    EXPECT_EQ(found["runs"][0]["status"], "failed");
    EXPECT_THAT(found["runs"][0]["message"].get<std::string>(), HasSubstr("missing.lxm"));
    EXPECT_EQ(found["runs"][1]["status"], "done");
}

}  // namespace
}  // namespace bench::test::smallest_study_test
