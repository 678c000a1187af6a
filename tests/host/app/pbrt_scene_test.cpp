// A scene of pbrt from outside: it is told by its name, renders, and an integrator of the command
// line takes the place of the scene's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "lxsrender_process.h"

namespace lxs::test::pbrt_scene_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string scene(const std::string& integrator) {
    return integrator +
           "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8 \"string filename\" "
           "\"named.exr\"\nSampler \"independent\" \"integer pixelsamples\" 3\n"
           "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n"
           "LightSource \"point\" \"float scale\" 30 \"point3 from\" [1 2 3]\nShape \"sphere\"\n";
}

TEST(PbrtScene, RendersAsItSays) {
    TemporaryFolder folder;
    folder.write("ball.pbrt", scene("Integrator \"path\" \"integer maxdepth\" 3\n"));
    const RunResult result = run_lxsrender(folder, {"ball.pbrt"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("warning")));
    EXPECT_THAT(result.err, HasSubstr("3 passes"));
    EXPECT_TRUE(std::filesystem::exists(folder / "named.exr"));
}

TEST(PbrtScene, AnotherIntegratorFindsItsOwnRadius) {
    TemporaryFolder folder;
    folder.write("ball.pbrt", scene("Integrator \"sppm\" \"float radius\" 0.0123 \"integer "
                                    "photonsperiteration\" 1000\n"));
    const RunResult own = run_lxsrender(folder, {"ball.pbrt", "--passes", "1", "--verbose"});
    EXPECT_EQ(own.exit_code, 0) << own.err;
    EXPECT_THAT(own.err, HasSubstr("0.0123"));
    const RunResult other =
        run_lxsrender(folder, {"ball.pbrt", "--passes", "1", "--verbose", "--integrator", "aips"});
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_THAT(other.err, Not(HasSubstr("0.0123")));
}

}  // namespace
}  // namespace lxs::test::pbrt_scene_test
