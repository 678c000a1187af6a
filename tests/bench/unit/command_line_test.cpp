// Protects aips-bench against bad input: exit codes, messages, and that nothing is rendered then.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "exit_code.h"
#include "study_file.h"

namespace bench::test::command_line_test {
namespace {

using testing::HasSubstr;

TEST(BenchCommandLine, MistakesExitWithTwoAndSayWhatIsWrong) {
    const TemporaryFolder folder;
    const struct {
        const char* arguments;
        const char* message;
    } cases[] = {
        {"", "subcommand"},
        {"measure", "subcommand"},
        {"run --methods sppm --out o", "--scenes is required"},
        {"run --scenes furnace --methods sppm", "--out is required"},
        {"run --scenes furnace --methods sppm --out o --budgets 1,-2",
         "expected a number above 0, found \"-2\""},
        {"run --scenes furnace --methods sppm --out o --budgets 0", "above 0"},
        {"run --scenes furnace --methods sppm --out o --seeds 0", "--seeds"},
        {"run --scenes furnace --methods sppm --out o --clock sun", "--clock"},
        {"run --scenes furnace --methods sppm --out o --variants free", "--variants"},
        {"run --scenes furnace --methods sppm,path,sppm --out o", "\"sppm\" is given twice"},
        {"run --scenes furnace --methods sppm --out o --set alpha=1",
         "expected plugin.parameter=value"},
        {"reference --scenes furnace --seconds 0", "above 0"},
        {"table", "dir is required"},
        {"table a b", "several are shown with --error only"},
        {"table a --error mean", "--error"},
        {"table a --budget 20", "--error"},
        {"agreement", "dir is required"},
    };
    for (const auto& [arguments, message] : cases) {
        const BenchResult result = run_bench(folder, arguments);
        EXPECT_EQ(result.exit_code, 2) << arguments << result.text;
        EXPECT_THAT(result.text, HasSubstr(message)) << arguments;
    }
}

TEST(BenchCommandLine, UnknownNamesExitWithThreeBeforeAnythingIsRendered) {
    const TemporaryFolder folder;
    folder.write("odd.json", R"({"photons_per_pass": 10, "fixed_startradius": 2, "references": [],
      "methods": [{"name": "odd", "integrator": "oddity", "description": ""},
                  {"name": "guess", "integrator": "aips", "description": "",
                   "set": ["guide=guesswork"]},
                  {"name": "idle", "integrator": "sppm", "description": "",
                   "set": ["lookupaccel=kdtree"]}]})");
    const struct {
        const char* arguments;
        const char* message;
    } cases[] = {
        {"run --scenes nowhere --methods sppm --out o", "unknown scene \"nowhere\""},
        {"run --scenes furnace --methods spmm --out o", "unknown method \"spmm\""},
        {"run --scenes furnace --methods sppm --out o --set spmm.alpha=1",
         "unknown integrator \"spmm\""},
        {"run --scenes furnace --methods sppm --out o --set sppm.alfa=1", "alfa"},
        {"run --scenes furnace --methods odd --method-table odd.json --out o",
         "method \"odd\" can't be run by this build"},
        {"run --scenes furnace --methods guess --method-table odd.json --out o",
         "unknown guide \"guesswork\""},
        {"run --scenes furnace --methods idle --method-table odd.json --out o", "no effect"},
        {"table .", "summary.json"},
        {"agreement .", "summary.json"},
    };
    for (const auto& [arguments, message] : cases) {
        const BenchResult result = run_bench(folder, arguments);
        EXPECT_EQ(result.exit_code, 3) << arguments << result.text;
        EXPECT_THAT(result.text, HasSubstr(message)) << arguments;
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/runs"));
        const auto study = folder.path() / "o";
        EXPECT_TRUE(!std::filesystem::exists(study) || std::filesystem::is_empty(study));
    }
}

TEST(BenchCommandLine, MethodsListsThoseThatThisBuildCanRun) {
    const TemporaryFolder folder;
    folder.write("m.json", R"({"photons_per_pass": 10, "fixed_startradius": 2, "references": [],
      "methods": [{"name": "plain", "integrator": "sppm", "description": ""},
                  {"name": "odd", "integrator": "oddity", "description": ""}]})");
    const BenchResult result = run_bench(folder, "methods --method-table m.json");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.text, HasSubstr("method \"odd\" can't be run by this build"));
    EXPECT_THAT(result.text, HasSubstr("\nplain\n"));
}

TEST(BenchCommandLine, UnwritableFolderExitsWithFive) {
    const TemporaryFolder folder;
    folder.write("file", "");
    const BenchResult result =
        run_bench(folder, "run --scenes furnace --methods sppm --out file/o --budgets 0.01");
    EXPECT_EQ(result.exit_code, 5) << result.text;
    EXPECT_THAT(result.text, HasSubstr("cannot make folder 'file/o'"));
}

TEST(BenchCommandLine, PageAndHelpListEveryExitCode) {
    const TemporaryFolder folder;
    const std::string help = run_bench(folder, "--help").text;
    const std::string page = read_file(BENCH_PAGE);
    for (const auto& [code, meaning] : kExitCodes) {
        EXPECT_THAT(page, HasSubstr(fmt::format("| {} | {} |", static_cast<int>(code), meaning)));
        EXPECT_THAT(help, HasSubstr(fmt::format("{}  {}", static_cast<int>(code), meaning)));
    }
}

}  // namespace
}  // namespace bench::test::command_line_test
