// Protects --checkpoint and --resume as a user meets them: a resumed render has the image of one
// without a break, and a checkpoint of another render, or a damaged one, is refused before anything
// is rendered and stays as it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::checkpoint_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kRefused = 6;
constexpr const char* kTroublesome = TEST_MODULES "/troublesome";

using Options = std::vector<std::string>;

Options operator+(Options a, const Options& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const Options kCheckpoint = {"--checkpoint", "check", "--checkpoint-interval", "0"};
const Options kResume = kCheckpoint + Options{"--resume"};

/// Light groups, a texture and a mesh from files, and something that disperses if asked for.
std::string scene_text(bool disperses) {
    const std::string glass = disperses ? "MakeNamedMaterial \"glass\" \"string type\" [\"glass\"] "
                                          "\"float cauchyb\" [0.02]\nNamedMaterial \"glass\"\n"
                                        : "";
    return small_scene("",
                       "LightGroup \"mesh\"\nLightSource \"infinite\" \"color L\" [.2 .3 .4] "
                       "\"string mapname\" [\"sky.ppm\"]\n" +
                           glass +
                           "Shape \"plymesh\" \"string filename\" [\"mesh.ply\"]\n"
                           "Include \"more.lxs\"\n");
}

constexpr const char* kMesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "-2 1 -1\n2 1 -1\n0 1 2\n3 0 1 2\n";

/// An image of one texel.
std::string sky(int blue) {
    return "P3\n1 1\n255\n50 60 " + std::to_string(blue) + "\n";
}

class CheckpointTest : public testing::Test {
  protected:
    CheckpointTest() { write_scene(false); }

    void write_scene(bool disperses) const {
        folder_.write("scene.lxs", scene_text(disperses));
        folder_.write("more.lxs", "Shape \"sphere\" \"float radius\" [0.5]\n");
        folder_.write("mesh.ply", kMesh);
        folder_.write("sky.ppm", sky(70));
    }
    RunResult run(const Options& options) const {
        return run_lxsrender(folder_, Options{"scene.lxs", "--stats", "stats.json"} + options);
    }
    /// Renders four of seven passes, as a render that is killed would have left them.
    void leave_checkpoint(const Options& options = {}) const {
        const RunResult result = run(kCheckpoint + Options{"--passes", "4"} + options);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        for (const char* name : {"out.exr", "out.png", "stats.json"})
            std::filesystem::remove(folder_ / name);
    }
    /// The render is refused with these words, nothing is rendered, the checkpoint stays.
    void expect_refusal(const Options& options, const std::string& message) const {
        const std::string before = folder_.read("check");
        const RunResult result = run(options + Options{"--passes", "7"});
        EXPECT_EQ(result.exit_code, kRefused) << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: "));
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_THAT(result.err, Not(HasSubstr("rendered pass")));
        EXPECT_FALSE(folder_.has("out.exr"));
        EXPECT_EQ(folder_.read("check"), before);
    }

    TemporaryFolder folder_;
};

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

TEST_F(CheckpointTest, AFileThatIsThereIsNeverReplacedUnasked) {
    leave_checkpoint();
    expect_refusal(kCheckpoint, "'check' is there already");
    folder_.write("check", "a letter to my aunt");
    expect_refusal(kCheckpoint, "'check' is there already");
    expect_refusal(kResume, "cannot resume from 'check': it is no checkpoint");
}

TEST_F(CheckpointTest, DamagedOnesAreRefused) {
    leave_checkpoint();
    const std::string whole = folder_.read("check");
    for (int i = 0; i < 5; ++i) {
        const std::size_t at = whole.size() * static_cast<std::size_t>(i) / 5;
        folder_.write("check", whole.substr(0, at));
        expect_refusal(kResume, "cannot resume from 'check': ");
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        folder_.write("check", damaged);
        expect_refusal(kResume, "cannot resume from 'check': ");
    }
    std::string foreign = whole;
    ++foreign[8];
    folder_.write("check", foreign);
    expect_refusal(kResume, "but this lxsrender reads version");
}

TEST_F(CheckpointTest, OtherRendersAreRefused) {
    leave_checkpoint();
    const struct {
        Options options;
        std::string message;
    } cases[] = {{{"--seed", "5"}, "the seed"},
                 {{"--set", "path.maxdepth=3"}, "the integrator, a setting or the size"},
                 {{"--width", "9"}, "the integrator, a setting or the size"},
                 {{"--sampler", "metropolis"}, "the integrator, a setting or the size"},
                 {{"--integrator", "sppm"}, "the build of lxsrender or of the integrator's"}};
    for (const auto& [options, message] : cases)
        expect_refusal(kResume + options, "it is of another render, which differs in: " + message);
}

TEST_F(CheckpointTest, ChangedFilesAreFound) {
    leave_checkpoint();
    const struct {
        const char* file;
        std::string text, message;
    } cases[] = {
        {"scene.lxs", scene_text(false) + "# a word\n", "the text of the scene"},
        {"more.lxs", "Shape \"sphere\" \"float radius\" [0.6]\n", "the text of the scene"},
        {"sky.ppm", sky(80), "a mesh, texture or other file"},
        {"mesh.ply", std::string(kMesh).replace(std::string(kMesh).find("0 1 2\n3"), 5, "0 1 3"),
         "a mesh, texture or other file"}};
    for (const auto& [file, text, message] : cases) {
        const std::string before = folder_.read(file);
        folder_.write(file, text);
        expect_refusal(kResume, "it is of another render, which differs in: " + message);
        folder_.write(file, before);
    }
    EXPECT_EQ(run(kResume + Options{"--passes", "7"}).exit_code, 0);
}

TEST_F(CheckpointTest, ThreadsBudgetsAndOutputNamesMayChange) {
    leave_checkpoint();
    const RunResult result = run({"--checkpoint", "check", "--resume", "--threads", "1", "--time",
                                  "0.001", "-o", "elsewhere.exr", "--strict"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(CheckpointTest, PlacesThatCantBeWrittenAreFoundBeforeRendering) {
    folder_.write("file", "");
    for (const char* place : {"nowhere/check", "file/check", "/proc/check", "."}) {
        const RunResult result = run({"--checkpoint", place, "--passes", "2"});
        EXPECT_EQ(result.exit_code, 5) << place << '\n' << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: cannot write '" + std::string(place) + "': "));
        EXPECT_FALSE(folder_.has("out.exr"));
    }
    for (const char* output : {"out.exr", "out.png", "stats.json", "./out.exr"}) {
        const RunResult result = run({"--checkpoint", output, "--passes", "2"});
        EXPECT_EQ(result.exit_code, kRefused) << output << '\n' << result.err;
        EXPECT_THAT(result.err, HasSubstr("can't be checkpoint and output"));
    }
}

TEST_F(CheckpointTest, AnIntegratorWithoutStateIsRefusedBeforeRendering) {
    const RunResult result = run({"--checkpoint", "check", "--integrator", "sleeper",
                                  "--plugin-path", kTroublesome, "--passes", "1"});
    EXPECT_EQ(result.exit_code, kRefused) << result.err;
    EXPECT_THAT(result.err, HasSubstr("\"sleeper\" can't be saved to 'check': this integrator "
                                      "can't be checkpointed"));
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

TEST_F(CheckpointTest, OptionsNeedAFile) {
    EXPECT_EQ(run({"--resume"}).exit_code, 2);
    EXPECT_EQ(run({"--checkpoint-interval", "3"}).exit_code, 2);
    EXPECT_EQ(run({"--checkpoint", "check", "--checkpoint-interval", "-1"}).exit_code, 2);
}

}  // namespace
}  // namespace lxs::test::checkpoint_test
