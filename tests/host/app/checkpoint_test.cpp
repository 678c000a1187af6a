// Protects --checkpoint and --resume as a user meets them: a resumed render has the image of one
// without a break, and what goes wrong with a checkpoint costs no image.
#include <signal.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "checkpoint_fixture.h"

namespace lxs::test::checkpoint_test {
namespace {

using testing::HasSubstr;

/// Name of the case, whether the scene disperses, options.
using Render = std::tuple<const char*, bool, Options>;

class ResumeTest : public CheckpointTest, public testing::WithParamInterface<Render> {};

TEST_P(ResumeTest, GivesTheBitsOfARenderWithoutABreak) {
    const auto& [name, disperses, options] = GetParam();
    write_scene(disperses);
    ASSERT_EQ(run(options + Options{"--passes", "7", "-o", "whole.exr"}).exit_code, 0);
    const auto whole_counts = nlohmann::json::parse(folder_.read("stats.json"))["counts"];
    leave_checkpoint(options);
    const RunResult result =
        run(options + kResume + Options{"--passes", "7", "--threads", "3", "-o", "broken.exr"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("resumed from 'check' after 4 passes"));
    EXPECT_EQ(folder_.read("broken.exr"), folder_.read("whole.exr"));
    EXPECT_EQ(folder_.read("broken.png"), folder_.read("whole.png"));
    const auto counts = nlohmann::json::parse(folder_.read("stats.json"))["counts"];
    for (const char* figure : {"passes", "rays", "photon paths", "samples per pixel"})
        EXPECT_EQ(counts[figure], whole_counts[figure]) << figure;
}

// In the wide one tables of lights were made anew three times before the break, and shadow rays
// wait to be learned from.
INSTANTIATE_TEST_SUITE_P(
    Path, ResumeTest,
    testing::Values(Render{"plain", false, {}}, Render{"by_wavelengths", true, {}},
                    Render{"learned_lights", false, {"--width", "128"}},
                    Render{"chains", false, {"--sampler", "metropolis", "--width", "64"}}),
    [](const auto& given) { return std::get<0>(given.param); });

TEST_F(CheckpointTest, RefusedTextureValuesAreThoseOfAllRuns) {
    folder_.write("more.lxs",
                  "Texture \"grey\" \"float\" \"checkerboard\"\n"
                  "Texture \"squares\" \"color\" \"mix\" \"color tex1\" [0 0 0] \"color tex2\" "
                  "[2 2 2] \"texture amount\" [\"grey\"]\n"
                  "Texture \"endless\" \"color\" \"scale\" \"texture tex1\" [\"squares\"] "
                  "\"color tex2\" [2e38 2e38 2e38]\n"
                  "MakeNamedMaterial \"bad\" \"string type\" [\"matte\"] \"texture Kd\" "
                  "[\"endless\"]\nNamedMaterial \"bad\"\n"
                  "Translate 0 -1.5 0 Shape \"sphere\" \"float radius\" [0.5]\n");
    const auto refused = [&] {
        return nlohmann::json::parse(folder_.read("stats.json"))["refused"];
    };
    ASSERT_EQ(run({"--passes", "7"}).exit_code, 0);
    const auto whole = refused();
    ASSERT_TRUE(whole.contains("texture values")) << whole.dump();
    leave_checkpoint();
    ASSERT_EQ(run(kResume + Options{"--passes", "7"}).exit_code, 0);
    EXPECT_EQ(refused(), whole);
}

TEST_F(CheckpointTest, ResumingAfterTheLastPassWritesTheImageAgain) {
    ASSERT_EQ(run(kCheckpoint + Options{"--passes", "4"}).exit_code, 0);
    const std::string image = folder_.read("out.exr");
    std::filesystem::remove(folder_ / "out.exr");
    ASSERT_EQ(run(kResume + Options{"--passes", "4"}).exit_code, 0);
    EXPECT_EQ(folder_.read("out.exr"), image);
    const RunResult fewer = run(kResume + Options{"--passes", "3"});
    EXPECT_EQ(fewer.exit_code, 0);
    EXPECT_THAT(fewer.err, HasSubstr("has 4 passes already, more than --passes 3"));
}

TEST_F(CheckpointTest, WithoutAFileResumeBeginsAndSaysSo) {
    const RunResult result = run(kResume + Options{"--passes", "2"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("there is no checkpoint 'check' yet"));
    EXPECT_TRUE(folder_.has("check"));
}

TEST_F(CheckpointTest, InterruptionLeavesACheckpointOfAllPassesSoFar) {
    {
        LxsrenderProcess process(folder_, {"scene.lxs", "--checkpoint", "check", "--time", "300"});
        ASSERT_TRUE(process.wait_for("pass 1"));
        process.send(SIGINT);
        ASSERT_EQ(process.wait().exit_code, 130);
    }
    const RunResult result = run(kResume + Options{"--passes", "1", "-o", "again.exr"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder_.read("again.exr"), folder_.read("out.exr"));
}

/// Runs lxsrender where no file can grow beyond `kilobytes`; gives what it says.
std::string run_with_file_limit(const TemporaryFolder& folder, int kilobytes,
                                const std::string& options) {
    const std::string command = "bash -c \"cd '" + folder.path().string() +
                                "'; trap '' XFSZ; ulimit -f " + std::to_string(kilobytes) +
                                "; exec '" LXSRENDER "' scene.lxs " + options + " 2> messages\"";
    EXPECT_EQ(std::system(command.c_str()), 0) << folder.read("messages");
    return folder.read("messages");
}

TEST_F(CheckpointTest, AFullDiskCostsTheCheckpointAndNotTheRender) {
    // Without what waits to be learned from, a checkpoint keeps its size.
    const Options options = {"--width", "64", "--set", "path.lightstrategy=powerimp"};
    leave_checkpoint(options);
    const std::string before = folder_.read("check");
    // Images are smaller: they hold floats, the checkpoint doubles.
    const std::string messages =
        run_with_file_limit(folder_, static_cast<int>(before.size() / 1024) - 1,
                            "--width 64 --set path.lightstrategy=powerimp "
                            "--checkpoint check --checkpoint-interval 0 --resume --passes 6");
    EXPECT_THAT(messages, HasSubstr("warning: no checkpoint after 5 passes: cannot write 'check'"
                                    ": File too large; the render goes on"));
    EXPECT_EQ(folder_.read("check"), before);
    ASSERT_EQ(run(options + Options{"--passes", "6", "-o", "whole.exr"}).exit_code, 0);
    EXPECT_EQ(folder_.read("out.exr"), folder_.read("whole.exr"));
}

TEST_F(CheckpointTest, WhatAKilledProcessLeftBehindIsRemoved) {
    folder_.write(".check.4194305.tmp", "cut off");
    folder_.write(".out.exr.4194305.tmp", "cut off");
    folder_.write(".out.exr.notes.tmp", "of somebody else");
    EXPECT_EQ(run(kCheckpoint + Options{"--passes", "2"}).exit_code, 0);
    EXPECT_FALSE(folder_.has(".check.4194305.tmp"));
    EXPECT_FALSE(folder_.has(".out.exr.4194305.tmp"));
    EXPECT_TRUE(folder_.has(".out.exr.notes.tmp"));
}

}  // namespace
}  // namespace lxs::test::checkpoint_test
