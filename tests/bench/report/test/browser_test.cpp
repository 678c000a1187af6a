// Protects the page as a reader opens it: in headless Chromium, from a file, without network.
// check_page.mjs says what is looked at.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "bench_process.h"
#include "synthetic_agreement.h"
#include "synthetic_study.h"

namespace bench::test::browser_test {
namespace {

namespace fs = std::filesystem;

/// Empty if the program isn't on the path.
fs::path find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        fs::path file = fs::path(folder) / name;
        if (::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

fs::path find_chromium() {
    for (const char* name : {"chromium-headless-shell", "chromium"}) {
        if (fs::path file = find_program(name); !file.empty()) return file;
    }
    return {};
}

TEST(ReportInBrowser, DrawsCurvesTablesAndPicturesAndFlips) {
    const fs::path chromium = find_chromium(), node = find_program("node");
    if (chromium.empty()) GTEST_SKIP() << "neither chromium-headless-shell nor chromium is there";
    if (node.empty()) GTEST_SKIP() << "node is not there";
    if (!fs::exists(BENCH_REPORT_PAGE)) GTEST_SKIP() << "npm is not there: no page is built";
    const TemporaryFolder folder;
    const Json summary = write_synthetic_study(folder.path());
    const std::string command = "report study --references references";
    const BenchResult untested = run_bench(folder, command + " --out untested.html");
    ASSERT_EQ(untested.exit_code, 0) << untested.text;
    write_synthetic_agreement(folder.path(), summary);
    const BenchResult report = run_bench(folder, command);
    ASSERT_EQ(report.exit_code, 0) << report.text;
    const fs::path page = folder.path() / "study/report.html";
    EXPECT_LT(fs::file_size(page), 10'000'000u);
    const BenchResult check = run_program(
        folder, node.string() + " '" CHECK_PAGE "' '" + page.string() + "' untested.html '" +
                    chromium.string() + "' '" BENCH_REPORT_PACKAGES "'");
    EXPECT_EQ(check.exit_code, 0) << check.text;
}

}  // namespace
}  // namespace bench::test::browser_test
