// Protects Ctrl-C: the first finishes the pass in flight, writes the image and exits with 130; the
// second exits at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>

#include "lxsrender_process.h"

namespace lxs::test::interruption_test {
namespace {

using testing::HasSubstr;

constexpr const char* kTroublesome = TEST_MODULES "/troublesome";

class InterruptionTest : public testing::TestWithParam<int> {};

TEST_P(InterruptionTest, FirstSignalWritesTheImage) {
    TemporaryFolder folder;
    folder.write("scene.lxs", small_scene());
    LxsrenderProcess process(folder, {"scene.lxs", "--time", "300", "--stats", "stats.json"});
    ASSERT_TRUE(process.wait_for("pass 1"));
    process.send(GetParam());
    const RunResult result = process.wait();
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_TRUE(folder.has("out.exr"));
    EXPECT_TRUE(folder.has("out.png"));
    EXPECT_THAT(folder.read("stats.json"), HasSubstr("\"interrupted\": true"));
    EXPECT_THAT(result.err, HasSubstr(": stopped by Ctrl-C or a signal"));
    EXPECT_THAT(result.err, HasSubstr("interrupted after "));
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptionTest, testing::Values(SIGINT, SIGTERM));

TEST(Interruption, SecondSignalExitsAtOnce) {
    TemporaryFolder folder;
    folder.write("scene.lxs", small_scene());
    LxsrenderProcess process(folder, {"scene.lxs", "--passes", "1", "--integrator", "sleeper",
                                      "--plugin-path", kTroublesome});
    ASSERT_TRUE(process.wait_for("sleeper: ready"));
    const auto start = std::chrono::steady_clock::now();
    process.send(SIGINT);
    process.send(SIGTERM);  // two of one kind might be merged into one
    const RunResult result = process.wait();
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_FALSE(folder.has("out.exr"));
}

}  // namespace
}  // namespace lxs::test::interruption_test
