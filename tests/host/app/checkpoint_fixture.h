// A scene with files of every kind beside it, rendered with checkpoints.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "lxsrender_process.h"

namespace lxs::test::checkpoint_test {

inline constexpr int kRefused = 6;

using Options = std::vector<std::string>;

inline Options operator+(Options a, const Options& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

inline const Options kCheckpoint = {"--checkpoint", "check", "--checkpoint-interval", "0"};
inline const Options kResume = kCheckpoint + Options{"--resume"};

/// Light groups, a texture and a mesh from files, and something that disperses if asked for.
inline std::string scene_text(bool disperses) {
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

inline constexpr const char* kMesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "-2 1 -1\n2 1 -1\n0 1 2\n3 0 1 2\n";

/// An image of one texel.
inline std::string sky(int blue) {
    return "P3\n1 1\n255\n50 60 " + std::to_string(blue) + "\n";
}

/// A scene in a folder of its own, and renders of it with checkpoints.
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
        EXPECT_THAT(result.err, testing::HasSubstr("error: "));
        EXPECT_THAT(result.err, testing::HasSubstr(message));
        EXPECT_THAT(result.err, testing::Not(testing::HasSubstr("rendered ")));
        EXPECT_FALSE(folder_.has("out.exr"));
        EXPECT_EQ(folder_.read("check"), before);
    }

    TemporaryFolder folder_;
};

}  // namespace lxs::test::checkpoint_test
