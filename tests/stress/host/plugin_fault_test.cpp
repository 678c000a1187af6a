// Protects the host from its plugins: whatever one throws, in whatever step and on whatever thread,
// or hands to the film, ends with a message that names it and a documented exit code, and the
// passes that were finished are saved.
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sabotaged_render.h"
#include "stress_case.h"

namespace lxs::test::plugin_fault_test {
namespace {

using testing::HasSubstr;

RunResult run(SabotagedRender& render, const std::string& deed) {
    render.folder.write("scene.lxs", small_scene());
    return render.run(deed, "", {"--passes", "3", "--stats", "stats.json"});
}

TEST(StressPlugin, ThatFailsBeforeTheFirstPass) {
    const struct {
        const char* deed;
        int exit_code;
        const char* message;
    } cases[] = {
        {"foreign exception in create", 4,
         "creating integrator \"saboteur\" failed with an exception of unknown type"},
        {"logic error in prepare", 4, "integrator \"saboteur\", prepare, failed: off by one"},
        {"foreign exception in prepare", 4, "prepare, failed with an exception of unknown type"},
        {"no memory in prepare", 1, "error: out of memory"},
    };
    for (const auto& [deed, exit_code, message] : cases) {
        SabotagedRender render;
        const RunResult result = run(render, deed);
        EXPECT_EQ(result.exit_code, exit_code) << deed << result.err;
        EXPECT_THAT(result.err, HasSubstr(message)) << deed;
        EXPECT_FALSE(render.folder.has("out.exr")) << deed;
    }
}

TEST(StressPlugin, ThatFailsInItsSecondPassLeavesTheFirst) {
    const std::pair<const char*, const char*> cases[] = {
        {"throw", "integrator \"saboteur\", pass 2, failed: no more paint"},
        {"foreign exception", "pass 2, failed with an exception of unknown type"},
        {"throw in tasks", "pass 2, failed: a task gave up"},
        {"foreign exception in tasks", "pass 2, failed with an exception of unknown type"},
        {"too few values", "failed: film: radiance doesn't match positions and light groups"},
        {"too many groups", "failed: film: radiance doesn't match positions and light groups"},
        {"weight of 0", "failed: film: the weight of a pass must be finite and positive"},
        {"wrong layer size", "failed: film: layer 'mine' has 3 values, not 48"},
        {"layer without end", "failed: film: a layer's name must have 1 to 200 printable bytes"},
        {"layer name with a zero byte", "failed: film: a layer's name must have 1 to 200"},
    };
    for (const auto& [deed, message] : cases) {
        SabotagedRender render;
        const RunResult result = run(render, deed);
        EXPECT_EQ(result.exit_code, 4) << deed << result.err;
        EXPECT_THAT(result.err, HasSubstr("saboteur.so': ")) << deed;
        EXPECT_THAT(result.err, HasSubstr(message)) << deed;
        EXPECT_THAT(result.err, HasSubstr("1 finished passes are in out.exr")) << deed;
        EXPECT_TRUE(render.folder.has("out.exr")) << deed;
        EXPECT_THAT(render.folder.read("stats.json"), HasSubstr("\"passes\": 1,")) << deed;
    }
    stress::record("ten ways to fail in pass 2", "all end with code 4, pass 1 saved");
}

TEST(StressPlugin, ThatGivesNoNumbersIsRefusedAndCounted) {
    SabotagedRender render;
    const RunResult result = run(render, "NaN");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("refused 48 film samples of light group \"default\""));
    EXPECT_EQ(run(render, "positions nowhere").exit_code, 0);
}

TEST(StressPlugin, ThatCannotGiveItsStatisticsLosesNeitherImageNorCounts) {
    SabotagedRender render;
    const RunResult result = run(render, "throw in statistics");
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_THAT(result.err, HasSubstr("integrator \"saboteur\", statistics, failed: lost count"));
    EXPECT_TRUE(render.folder.has("out.exr"));
    EXPECT_THAT(render.folder.read("stats.json"), HasSubstr("\"passes\": 3,"));
}

TEST(StressPlugin, WhoseFiguresAreNoJson) {
    SabotagedRender render;
    const RunResult result = run(render, "none");  // bytes that are no UTF-8, not a number
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(render.folder.read("stats.json"), HasSubstr("\"not a number\": null"));
}

}  // namespace
}  // namespace lxs::test::plugin_fault_test
