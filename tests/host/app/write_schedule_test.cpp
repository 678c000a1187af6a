// Protects the image so far: the first one at once, further ones as often as they were asked for
// and at no price worth speaking of, and none of them changes the image.
#include "lxs/host/write_schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxsrender_process.h"

namespace lxs::test::write_schedule_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(WriteSchedule, FirstIsDueAtOnceAndFurtherOnesAfterAnInterval) {
    WriteSchedule schedule(5, WriteCost::Whatever);
    EXPECT_TRUE(schedule.due(0.1, 0.1));
    schedule.written(0.1, 100);
    EXPECT_FALSE(schedule.due(5, std::nullopt));
    EXPECT_TRUE(schedule.due(5.1, std::nullopt));
}

TEST(WriteSchedule, NothingIsDueWithoutAnInterval) {
    EXPECT_FALSE(WriteSchedule(0, WriteCost::Whatever).due(100, 100.0));
    EXPECT_FALSE(WriteSchedule(0, WriteCost::Bounded).due(100, 100.0));
}

TEST(WriteSchedule, SlowWritesStretchABoundedInterval) {
    WriteSchedule schedule(12, WriteCost::Bounded);
    EXPECT_TRUE(schedule.due(0.1, 60.0));  // the first, whatever it takes
    schedule.written(0.1, 0.5);
    EXPECT_FALSE(schedule.due(13, 60.0));
    EXPECT_FALSE(schedule.due(99, 60.0));
    EXPECT_TRUE(schedule.due(100, 60.0));  // two of half a second in 100 s
    schedule.written(100, 0.5);
    EXPECT_FALSE(schedule.due(149, 60.0));
    EXPECT_TRUE(schedule.due(150, 60.0));
}

TEST(WriteSchedule, TakesOnePercentOfALongRender) {
    WriteSchedule schedule(1, WriteCost::Bounded);
    double spent = 0;
    for (double seconds = 1; seconds < 2000; ++seconds) {
        if (!schedule.due(seconds, std::nullopt)) continue;
        schedule.written(seconds, 0.3);
        spent += 0.3;
    }
    EXPECT_LE(spent, 20);
    EXPECT_GT(spent, 19);
}

TEST(WriteSchedule, WhatIsAboutToEndIsWaitedFor) {
    EXPECT_FALSE(WriteSchedule(12, WriteCost::Bounded).due(0.1, 0.9));
    EXPECT_TRUE(WriteSchedule(12, WriteCost::Bounded).due(0.1, 1.1));
}

class SnapshotTest : public testing::Test {
  protected:
    SnapshotTest() { folder_.write("scene.lxs", small_scene()); }
    TemporaryFolder folder_;
};

TEST_F(SnapshotTest, APictureIsThereAfterTheFirstPass) {
    const LxsrenderProcess process(folder_, {"scene.lxs", "--time", "300"});
    ASSERT_TRUE(
        process.wait_for("the picture so far is in out.png; it is written anew about every "
                         "12 s"));
    EXPECT_TRUE(folder_.has("out.png"));
}

TEST_F(SnapshotTest, IntervalComesFromTheFilmUnlessTheCommandLineHasOne) {
    folder_.write("scene.lxs", small_scene("Film \"fleximage\" \"integer writeinterval\" [180] "
                                           "\"integer displayinterval\" [5] \"string filename\" "
                                           "[\"out\"] \"integer xresolution\" [8]"));
    EXPECT_TRUE(LxsrenderProcess(folder_, {"scene.lxs", "--time", "300"}).wait_for("every 5 s"));
    EXPECT_TRUE(LxsrenderProcess(folder_, {"scene.lxs", "--time", "300", "--write-every", "7.5"})
                    .wait_for("every 7.5 s"));
}

TEST_F(SnapshotTest, BitsAreTheSameHoweverOftenTheImageIsWritten) {
    for (const char* every : {"0", "1e-9"}) {
        const RunResult result =
            run_lxsrender(folder_, {"scene.lxs", "--passes", "5", "--write-every", every, "-o",
                                    std::string("every-") + every + ".exr"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        if (std::string(every) == "0") {
            EXPECT_THAT(result.err, Not(HasSubstr("so far")));
        } else {
            EXPECT_THAT(result.err, HasSubstr("so far"));
        }
    }
    EXPECT_EQ(folder_.read("every-0.exr"), folder_.read("every-1e-9.exr"));
    EXPECT_EQ(folder_.read("every-0.png"), folder_.read("every-1e-9.png"));
    EXPECT_EQ(folder_.entries(), 5u);  // scene, two EXRs, two PNGs
}

TEST_F(SnapshotTest, ImpossibleIntervalsAreRefused) {
    for (const char* every : {"-1", "nan", "inf", "often"}) {
        const RunResult result = run_lxsrender(folder_, {"scene.lxs", "--write-every", every});
        EXPECT_EQ(result.exit_code, 2) << every;
        EXPECT_THAT(result.err, HasSubstr("--write-every: expected a number of at least 0, found"));
    }
}

}  // namespace
}  // namespace lxs::test::write_schedule_test
