// Protects --seed-per-frame: which number a frame has, and that frames have noise of their own.
#include "lxs/host/frame_number.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxsrender_process.h"

namespace lxs::test {
namespace {

TEST(FrameNumber, IsTheLastInTheFilesName) {
    EXPECT_EQ(frame_number("frame_0007.lxs"), 7u);
    EXPECT_EQ(frame_number("/shots/12/take3_0010.lxs"), 10u);
    EXPECT_EQ(frame_number("Scene.Camera.00001.lxs"), 1u);
    EXPECT_EQ(frame_number("0.lxs"), 0u);
    EXPECT_EQ(frame_number("7_last.lxs"), 7u);
    EXPECT_EQ(frame_number("999999999.lxs"), 999999999u);
}

TEST(FrameNumber, MayBeMissing) {
    for (const char* name : {"frame.lxs", "12/frame.lxs", "-", "", "frame_1234567890.lxs"})
        EXPECT_EQ(frame_number(name), std::nullopt) << name;
}

class SeedPerFrame : public testing::Test {
  protected:
    SeedPerFrame() {
        for (const char* name : {"f1.lxs", "f2.lxs", "still.lxs"})
            folder_.write(name, small_scene());
    }
    std::string image(std::vector<std::string> options) const {
        options.insert(options.end(), {"--passes", "2", "-o", "out.exr"});
        const RunResult result = run_lxsrender(folder_, options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return folder_.read("out.png");
    }
    TemporaryFolder folder_;
};

TEST_F(SeedPerFrame, GivesNoiseOfItsOwn) {
    EXPECT_EQ(image({"f1.lxs"}), image({"f2.lxs"}));
    EXPECT_NE(image({"f1.lxs", "--seed-per-frame"}), image({"f2.lxs", "--seed-per-frame"}));
    EXPECT_EQ(image({"f2.lxs", "--seed-per-frame", "--seed", "3"}),
              image({"still.lxs", "--seed", "8589934595"}));
}

TEST_F(SeedPerFrame, NeedsANumber) {
    const RunResult result = run_lxsrender(folder_, {"still.lxs", "--seed-per-frame"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, testing::HasSubstr("as frame_0007.lxs has: still.lxs"));
}

}  // namespace
}  // namespace lxs::test
