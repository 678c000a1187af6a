// Protects --learned-out and --learned-in as a user meets them: the image of a render is the same
// with and without the first; what can't be begun with is refused before anything is rendered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxsrender_process.h"

namespace lxs::test {
namespace {

using testing::HasSubstr;
using Options = std::vector<std::string>;

/// Two lamps, so that there is something to learn of them, and glass.
std::string frame(double lamp) {
    return small_scene("", "LightSource \"point\" \"point from\" [" + std::to_string(lamp) +
                               " -5 3] \"color L\" [20 20 20]\n"
                               "Translate 0.8 -1.2 0\nMaterial \"glass\"\n"
                               "Shape \"sphere\" \"float radius\" [0.4]\n");
}

class LearnedFileTest : public testing::Test {
  protected:
    LearnedFileTest() {
        folder_.write("frame_1.lxs", frame(1));
        folder_.write("frame_2.lxs", frame(1.5));
    }
    RunResult run(const std::string& scene, const Options& more,
                  const std::string& integrator = "aips") const {
        Options options{
            scene, "--seed-per-frame", "--integrator", integrator, "--width", "64", "--passes", "4",
            "-o",  "out.exr"};
        options.insert(options.end(), more.begin(), more.end());
        return run_lxsrender(folder_, options);
    }
    std::string image(const std::string& scene, const Options& more,
                      const std::string& integrator = "aips") const {
        const RunResult result = run(scene, more, integrator);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return folder_.read("out.exr");
    }
    void expect_refusal(const Options& options, const std::string& message,
                        const std::string& integrator = "aips", int code = 3) const {
        std::filesystem::remove(folder_ / "out.exr");
        const RunResult result = run("frame_2.lxs", options, integrator);
        EXPECT_EQ(result.exit_code, code) << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: "));
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_FALSE(folder_.has("out.exr"));
    }
    TemporaryFolder folder_;
};

TEST_F(LearnedFileTest, ToKeepItChangesNoBit) {
    for (const char* integrator : {"aips", "path"}) {
        const std::string plain = image("frame_1.lxs", {}, integrator);
        EXPECT_EQ(image("frame_1.lxs", {"--learned-out", "a"}, integrator), plain);
        EXPECT_TRUE(folder_.has("a"));
    }
}

TEST_F(LearnedFileTest, ToBeginWithItGivesTheSameBitsEachTime) {
    for (const char* integrator : {"aips", "path"}) {
        const Options begin{"--learned-in", "a"};
        image("frame_1.lxs", {"--learned-out", "a"}, integrator);
        const std::string cold = image("frame_2.lxs", {"--threads", "1"}, integrator);
        const std::string warm =
            image("frame_2.lxs", {"--learned-in", "a", "--threads", "1"}, integrator);
        EXPECT_NE(warm, cold);
        EXPECT_EQ(image("frame_2.lxs", {"--learned-in", "a", "--threads", "3"}, integrator), warm);
        const Options check{"--learned-in", "a", "--checkpoint", "c", "--resume"};
        Options first = check;
        first.insert(first.end(), {"--passes", "2"});
        Options options{"frame_2.lxs", "--seed-per-frame", "--integrator",
                        integrator,    "--width",          "64",
                        "-o",          "out.exr"};
        options.insert(options.end(), first.begin(), first.end());
        const RunResult begun = run_lxsrender(folder_, options);
        EXPECT_EQ(begun.exit_code, 0) << begun.err;
        EXPECT_EQ(image("frame_2.lxs", check, integrator), warm);
        std::filesystem::remove(folder_ / "c");
    }
}

TEST_F(LearnedFileTest, ACheckpointBelongsToWhatItBeganWith) {
    image("frame_1.lxs", {"--learned-out", "a"});
    image("frame_2.lxs", {"--learned-in", "a", "--checkpoint", "c"});
    expect_refusal({"--checkpoint", "c", "--resume"},
                   "it is of another render, which differs in: what was learned before", "aips", 6);
}

TEST_F(LearnedFileTest, WhatItIsNotIsRefused) {
    expect_refusal({"--learned-in", "a"}, "cannot begin with 'a': it can't be read: No such file");
    folder_.write("a", "a letter to my aunt");
    expect_refusal({"--learned-in", "a"}, "cannot begin with 'a': it is no file of --learned-out");
    image("frame_1.lxs", {"--checkpoint", "c", "--learned-out", "a"});
    expect_refusal({"--learned-in", "c"}, "it is no file of --learned-out");
    expect_refusal({"--learned-in", "a"}, "\"aips\" learned it, and this render is by \"path\"",
                   "path");
    const std::string whole = folder_.read("a");
    for (int i = 1; i < 5; ++i) {
        const std::size_t at = whole.size() * static_cast<std::size_t>(i) / 5;
        folder_.write("a", whole.substr(0, at));
        expect_refusal({"--learned-in", "a"}, "cannot begin with 'a': it is cut off");
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        folder_.write("a", damaged);
        expect_refusal({"--learned-in", "a"}, "it is damaged: its checksum");
    }
    std::string foreign = whole;
    ++foreign[8];
    folder_.write("a", foreign);
    expect_refusal({"--learned-in", "a"}, "but this lxsrender reads version 1");
}

TEST_F(LearnedFileTest, PlacesAreLookedAtBeforeRendering) {
    expect_refusal({"--learned-out", "nowhere/a"}, "cannot write 'nowhere/a': ", "aips", 5);
    expect_refusal(
        {"--learned-out", "out.exr"},
        "cannot write what is learned to 'out.exr': it is the same file as the image 'out.exr'",
        "aips", 5);
    image("frame_1.lxs", {"--learned-out", "a"});
    expect_refusal({"--learned-in", "a", "--learned-out", "a", "--checkpoint", "c"},
                   "cannot write what is learned to 'a': it is the same file as that of "
                   "--learned-in, 'a'",
                   "aips", 5);
    image("frame_2.lxs", {"--learned-in", "a", "--learned-out", "a"});
}

/// What a render would know before its first pass must not come from that pass's own numbers.
TEST_F(LearnedFileTest, TheSameSeedIsRefused) {
    image("frame_2.lxs", {"--learned-out", "a"});
    expect_refusal({"--learned-in", "a"}, "with this render's own random numbers, seed 8589934592");
}

TEST_F(LearnedFileTest, AnIntegratorThatKeepsNothingIsRefused) {
    expect_refusal({"--learned-out", "a", "--plugin-path", TEST_MODULES "/troublesome"},
                   "\"sleeper\" has nothing for 'a': this integrator keeps nothing of what it "
                   "learns",
                   "sleeper");
}

}  // namespace
}  // namespace lxs::test
