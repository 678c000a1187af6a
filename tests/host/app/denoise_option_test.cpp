// Protects the option --denoise: a layer of its own, a picture of it, the image's bits as without,
// at the end alone where that is asked for, the same after a pause, and a checkpoint of another
// kind refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string_view>
#include <thread>

#include "lxsrender_process.h"

namespace lxs::test::denoise_option_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Options = std::vector<std::string>;

/// By the header of an EXR: the attribute's name, its kind, and how many characters it has.
bool has_ten_passes(const std::string& exr) {
    constexpr std::string_view kAttribute("passes\0string\0", 14);
    const std::size_t at = exr.find(kAttribute);
    return at != std::string::npos && exr[at + kAttribute.size()] > 1;
}

/// A sphere under a lamp that has a size, and with it noise.
class DenoiseOptionTest : public testing::Test {
  protected:
    DenoiseOptionTest() {
        folder_.write("scene.lxs",
                      small_scene("Film \"fleximage\" \"integer xresolution\" [8] "
                                  "\"integer yresolution\" [6] \"string filename\" [\"out\"] ",
                                  "AttributeBegin\nAreaLightSource \"area\"\nTranslate 0 0 4\n"
                                  "Shape \"sphere\" \"float radius\" [1.5]\nAttributeEnd\n"));
    }
    RunResult run(Options options) const {
        options.insert(options.begin(), {"scene.lxs", "--integrator", "path"});
        return run_lxsrender(folder_, std::move(options));
    }
    /// Whether the EXR that is written after each pass has a denoised layer after the tenth.
    bool denoises_so_far(const std::string& option) {
        LxsrenderProcess process(folder_, {"scene.lxs", "--integrator", "path", "--time", "300",
                                           "--write-every", "1e-9", option});
        EXPECT_TRUE(process.wait_for("so far"));
        std::string image;
        for (int i = 0; i < 3000 && !has_ten_passes(image); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            if (folder_.has("out.exr")) image = folder_.read("out.exr");
        }
        EXPECT_TRUE(has_ten_passes(image));
        process.send(SIGINT);
        EXPECT_EQ(process.wait().exit_code, 130);
        EXPECT_THAT(folder_.read("out.exr"), HasSubstr("denoised.G"));
        return image.find("denoised.G") != std::string::npos;
    }

    TemporaryFolder folder_;
};

TEST_F(DenoiseOptionTest, WritesALayerAndAPictureOfIt) {
    ASSERT_EQ(run({"--passes", "8"}).exit_code, 0);
    const std::string picture = folder_.read("out.png");
    EXPECT_THAT(folder_.read("out.exr"), Not(HasSubstr("denoised.G")));
    const RunResult result = run({"--passes", "8", "--denoise"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(folder_.read("out.exr"), HasSubstr("denoised.G"));
    EXPECT_THAT(folder_.read("out.exr"), Not(HasSubstr("albedo.G")));
    EXPECT_NE(folder_.read("out.png"), picture);
}

TEST_F(DenoiseOptionTest, TooFewPassesGiveTheImageAsItIs) {
    ASSERT_EQ(run({"--passes", "2"}).exit_code, 0);
    const std::string picture = folder_.read("out.png");
    ASSERT_EQ(run({"--passes", "2", "--denoise"}).exit_code, 0);
    EXPECT_EQ(folder_.read("out.png"), picture);
    EXPECT_THAT(folder_.read("out.exr"), Not(HasSubstr("denoised.G")));
}

TEST_F(DenoiseOptionTest, LastLeavesTheImagesSoFarAsTheyAre) {
    EXPECT_TRUE(denoises_so_far("--denoise"));
    EXPECT_FALSE(denoises_so_far("--denoise=last"));
    ASSERT_EQ(run({"--passes", "8", "--denoise"}).exit_code, 0);
    const std::string whole = folder_.read("out.exr"), picture = folder_.read("out.png");
    ASSERT_EQ(run({"--passes", "8", "--denoise=last"}).exit_code, 0);
    EXPECT_EQ(folder_.read("out.exr"), whole);
    EXPECT_EQ(folder_.read("out.png"), picture);
}

TEST_F(DenoiseOptionTest, APauseChangesNoBit) {
    ASSERT_EQ(run({"--passes", "21", "--denoise"}).exit_code, 0);
    const std::string whole = folder_.read("out.exr"), picture = folder_.read("out.png");
    ASSERT_EQ(run({"--passes", "10", "--denoise", "--checkpoint", "check"}).exit_code, 0);
    const RunResult result =
        run({"--passes", "21", "--denoise", "--checkpoint", "check", "--resume"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder_.read("out.exr"), whole);
    EXPECT_EQ(folder_.read("out.png"), picture);
}

TEST_F(DenoiseOptionTest, ACheckpointOfAnotherKindIsRefused) {
    const Options check{"--passes", "4", "--checkpoint", "check", "--resume"};
    Options denoises = check;
    denoises.emplace_back("--denoise");
    ASSERT_EQ(run(check).exit_code, 0);
    const RunResult without = run(denoises);
    EXPECT_EQ(without.exit_code, 6);
    EXPECT_THAT(without.err, HasSubstr("it was saved without what --denoise needs"));
    denoises[3] = "other";
    ASSERT_EQ(run(denoises).exit_code, 0);
    const RunResult with = run({"--passes", "4", "--checkpoint", "other", "--resume"});
    EXPECT_EQ(with.exit_code, 6);
    EXPECT_THAT(with.err, HasSubstr("it was saved by a render with --denoise"));
}

}  // namespace
}  // namespace lxs::test::denoise_option_test
