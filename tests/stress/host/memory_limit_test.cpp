// Protects renders under an address-space limit: wherever memory ends, the program says so, exits
// with its code for that, and never crashes; passes that were finished are saved.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "lxsrender_process.h"
#include "sabotaged_render.h"
#include "stress_case.h"

namespace lxs::test::memory_limit_test {
namespace {

using testing::HasSubstr;

constexpr rlim_t kMiB = rlim_t{1} << 20;
constexpr const char* kNoLimits = "a sanitizer reserves address space, and ends where none is left";

std::function<void()> at_most(rlim_t bytes) {
    return [bytes] {
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_AS, &limit);
    };
}

RunResult run_within(const TemporaryFolder& folder, rlim_t bytes,
                     std::vector<std::string> arguments) {
    return LxsrenderProcess(folder, std::move(arguments), "", at_most(bytes)).wait();
}

/// The least limit under which the program's libraries start at all: what fails below is no code
/// of the project's.
rlim_t least_to_start(const TemporaryFolder& folder) {
    rlim_t fails = 0, starts = 4096 * kMiB;
    while (starts - fails > 4 * kMiB) {
        const rlim_t middle = (starts + fails) / 2;
        (run_within(folder, middle, {"--list-plugins"}).exit_code == 0 ? starts : fails) = middle;
    }
    return starts;
}

/// Tens of thousands of triangles, a photon pass of tens of megabytes.
std::string hungry_scene() {
    std::string positions, indices;
    constexpr int kSide = 150;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            positions += std::to_string(x) + " " + std::to_string(y) + " 0 ";
            if (x == 0 || y == 0) continue;
            for (const int i : {y * kSide + x, y * kSide + x - 1, (y - 1) * kSide + x})
                indices += std::to_string(i) + " ";
        }
    }
    return small_scene("SurfaceIntegrator \"aips\" \"integer photonperpass\" [300000]\n",
                       "Shape \"trianglemesh\" \"integer indices\" [" + indices +
                           "]\n \"point P\" [" + positions + "]\n");
}

TEST(StressMemory, LimitsAtWhateverPointEndWithAMessage) {
    if (AIPS_SANITIZED) GTEST_SKIP() << kNoLimits;
    TemporaryFolder folder;
    folder.write("scene.lxs", hungry_scene());
    const rlim_t least = least_to_start(folder);
    const rlim_t step = stress::sized<rlim_t>(24, 2) * kMiB;
    int out_of_memory = 0, rendered = 0;
    for (rlim_t limit = least; limit < least + 500 * kMiB && rendered < 2; limit += step) {
        const RunResult result =
            run_within(folder, limit, {"scene.lxs", "--passes", "2", "--threads", "2", "--quiet"});
        EXPECT_THAT(result.exit_code, testing::AnyOf(0, 1, 4)) << limit / kMiB << result.err;
        if (result.exit_code == 0) {
            ++rendered;
            continue;
        }
        ++out_of_memory;
        // The last is that of a thread that finds no room for its stack.
        EXPECT_THAT(result.err, testing::AnyOf(HasSubstr("error: out of memory"),
                                               HasSubstr("': can't be loaded: "),
                                               HasSubstr("Embree fails: error "),
                                               HasSubstr("Resource temporarily unavailable")))
            << limit / kMiB;
    }
    EXPECT_GT(out_of_memory, 0);
    stress::record("limits from " + std::to_string(least / kMiB) + " MiB in steps of " +
                       std::to_string(step / kMiB) + " MiB",
                   std::to_string(out_of_memory) + " ended with a message, " +
                       std::to_string(rendered) + " rendered, none crashed");
}

TEST(StressMemory, PassThatFindsNoneKeepsThePassesBefore) {
    if (AIPS_SANITIZED) GTEST_SKIP() << kNoLimits;
    for (const std::string deed : {"no memory", "all memory"}) {
        SabotagedRender render;
        render.folder.write("scene.lxs", small_scene());
        const RunResult result =
            render.run(deed, "", {"--passes", "5", "--set", "saboteur.pass=3"});
        EXPECT_EQ(result.exit_code, 1) << result.err;
        EXPECT_THAT(result.err, HasSubstr("3 finished passes are in out.exr and out.png"));
        EXPECT_TRUE(render.folder.has("out.exr"));
        EXPECT_THAT(result.err, HasSubstr("error: out of memory"));
    }
}

}  // namespace
}  // namespace lxs::test::memory_limit_test
