// Protects: text that nests or repeats without end is refused at the place where it becomes
// senseless, in time and memory that the text's own size bounds.
#include <gtest/gtest.h>

#include "bounded_run.h"
#include "stress_case.h"

namespace nesting_test {
namespace {

using stress::BoundedRun;
using stress::Pipe;
using stress::run_lxsrender;

/// `piece` again and again, at least `bytes` of it.
void repeat(const Pipe& pipe, const std::string& piece, double bytes) {
    std::string block;
    while (block.size() < (std::size_t{1} << 20))
        block += piece;
    for (double written = 0; written < bytes; written += static_cast<double>(block.size())) {
        if (!pipe(block)) return;
    }
}

/// Standard input of `begin` and then `bytes` of `piece`; the text is held once, and once more
/// while its buffer grows.
BoundedRun render_endless(const std::string& begin, const std::string& piece, double bytes) {
    const files::TemporaryFolder folder;
    stress::RunOptions options;
    options.bounds = {.cpu_seconds = 10 + bytes / 2e7, .megabytes = 400 + 3 * bytes / 1e6};
    options.feed = [&](const Pipe& pipe) {
        if (pipe(begin)) repeat(pipe, piece, bytes);
    };
    return run_lxsrender(folder, {"-", "--passes", "1"}, options);
}

std::string megabytes(double bytes) {
    return std::to_string(static_cast<int>(bytes / 1e6)) + " MB";
}

const double kBytes = stress::sized(3e7, 1e9);

TEST(StressInput, NestedBrackets) {
    const BoundedRun run =
        render_endless("Film \"fleximage\" \"integer xresolution\" ", "[", kBytes);
    stress::expect_refused(run, "<standard input>:1:41: error: lists do not nest");
    stress::record(megabytes(kBytes) + " of [ from a pipe", stress::figure_of(run));
}

TEST(StressInput, NestedScopes) {
    const BoundedRun run =
        render_endless("WorldBegin\n", "AttributeBegin TransformBegin\n", kBytes);
    stress::expect_refused(run,
                           "<standard input>:5002:1: error: AttributeBegin nests deeper than "
                           "10000 levels");
    stress::record(megabytes(kBytes) + " of AttributeBegin TransformBegin", stress::figure_of(run));
}

TEST(StressInput, ObjectsInThemselvesAndDeepOnes) {
    std::string world = "ObjectBegin \"0\" Shape \"sphere\" ObjectEnd\n";
    for (int i = 1; i < 40; ++i) {
        const std::string inner = "ObjectInstance \"" + std::to_string(i - 1) + "\" ";
        world += "ObjectBegin \"" + std::to_string(i) + "\" ";
        for (int copy = 0; copy < 4; ++copy)
            world += inner;
        world += "ObjectEnd\n";
    }
    const files::TemporaryFolder folder;
    folder.write("scene.lxs", stress::small_scene("", world + "ObjectInstance \"39\""));
    const BoundedRun run = run_lxsrender(folder, {"scene.lxs", "--passes", "1"});
    stress::expect_refused(run, "scene.lxs:47:16: error: more than ten million instances");
    stress::record("4^39 instances by 40 levels of objects", stress::figure_of(run));
}

TEST(StressInput, ListWithoutEnd) {
    const double bytes = kBytes / 3;  // numbers take four times their text
    const files::TemporaryFolder folder;
    stress::RunOptions options;
    options.bounds = {.cpu_seconds = 10 + bytes / 2e6, .megabytes = 400 + 16 * bytes / 1e6};
    options.feed = [&](const Pipe& pipe) {
        if (pipe("Film \"fleximage\" \"float cropwindow\" [")) repeat(pipe, "1 ", bytes);
    };
    const BoundedRun run = run_lxsrender(folder, {"-", "--passes", "1"}, options);
    stress::expect_refused(run, "<standard input>:1:37: error: this list has no closing ']'");
    stress::record(megabytes(bytes) + " of numbers in a list", stress::figure_of(run));
}

TEST(StressInput, StatementWithManyParameters) {
    const int count = stress::sized(100'000, 1'000'000);
    std::string statement = "Shape \"sphere\"";
    for (int i = 0; i < count; ++i)
        statement += " \"float p" + std::to_string(i) + "\" [1]";
    const files::TemporaryFolder folder;
    folder.write("scene.lxs", stress::small_scene("", statement));
    stress::RunOptions options;
    options.bounds = {.cpu_seconds = 10 + count / 1e4, .megabytes = 400 + count * 2e-3};
    const BoundedRun run = run_lxsrender(folder, {"scene.lxs", "--passes", "1"}, options);
    EXPECT_EQ(run.exit_code, 0) << run.err.substr(0, 2000);
    EXPECT_NE(run.err.find(" of this kind, also "), std::string::npos);
    EXPECT_LT(run.err.size(), 3000u);
    stress::record(std::to_string(count) + " unknown parameters in one statement",
                   stress::figure_of(run));
}

class StressIncludes : public testing::Test {
  protected:
    BoundedRun render(const std::string& world) {
        folder_.write("scene.lxs", stress::small_scene("", world));
        return run_lxsrender(folder_, {"scene.lxs", "--passes", "1"},
                             {.bounds = {.cpu_seconds = 60, .megabytes = 600}});
    }
    files::TemporaryFolder folder_;
};

TEST_F(StressIncludes, Cycle) {
    folder_.write("a.lxo", "# a\nInclude \"sub/b.lxo\"\n");
    folder_.write("sub/b.lxo", "Include \"../a.lxo\"\n");
    const BoundedRun run = render("Include \"a.lxo\"");
    stress::expect_refused(run, "b.lxo:1:9: error: Include leads in a circle: ");
    EXPECT_NE(run.err.find("included from "), std::string::npos);
    stress::record("a.lxo -> sub/b.lxo -> a.lxo", stress::figure_of(run));
}

TEST_F(StressIncludes, Depth) {
    for (int i = 0; i < 40; ++i)
        folder_.write(std::to_string(i) + ".lxo", "Include \"" + std::to_string(i + 1) + ".lxo\"");
    const BoundedRun run = render("Include \"0.lxo\"");
    stress::expect_refused(run, "31.lxo:1:9: error: Include nests deeper than 32 levels");
    stress::record("40 files, each includes the next", stress::figure_of(run));
}

/// Each file's text stays, with places in it; each took a megabyte, whatever its size.
TEST_F(StressIncludes, ManySmallOnes) {
    constexpr int kFiles = 2000;
    std::string includes;
    for (int i = 0; i < kFiles; ++i) {
        folder_.write(std::to_string(i) + ".lxo", "Shape \"disk\"\n");
        includes += "Include \"" + std::to_string(i) + ".lxo\"\n";
    }
    const BoundedRun run = render(includes);
    EXPECT_EQ(run.exit_code, 0) << run.err.substr(0, 2000);
    EXPECT_LT(run.peak_megabytes, AIPS_SANITIZED ? 1000 : 250);
    stress::record("2000 files of one shape each", stress::figure_of(run) + " of at most 250");
}

/// 2^30 files, and not one of them twice in a chain.
TEST_F(StressIncludes, EachTwice) {
    for (int i = 0; i < 30; ++i) {
        const std::string next = "Include \"" + std::to_string(i + 1) + ".lxo\"\n";
        folder_.write(std::to_string(i) + ".lxo", next + next);
    }
    folder_.write("30.lxo", "# nothing\n");
    const BoundedRun run = render("Include \"0.lxo\"");
    stress::expect_refused(run, "error: Include reads more than 100000 files");
    stress::record("30 files, each includes the next twice", stress::figure_of(run));
}

}  // namespace
}  // namespace nesting_test
