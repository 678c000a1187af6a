// Protects checkpoints and renders from one another: a checkpoint of another render, or a damaged
// one, is refused before anything is rendered and stays as it is.
#include "checkpoint_fixture.h"

namespace lxs::test::checkpoint_test {
namespace {

using testing::HasSubstr;

constexpr const char* kTroublesome = TEST_MODULES "/troublesome";

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

TEST_F(CheckpointTest, ThreadsBudgetsAndWhatIsWrittenMayChange) {
    leave_checkpoint();
    const RunResult result =
        run({"--checkpoint", "check", "--resume", "--threads", "1", "--time", "0.001", "-o",
             "elsewhere.png", "--strict", "--exposure", "1", "--write-every", "3"});
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
        EXPECT_EQ(result.exit_code, 5) << output << '\n' << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: cannot write the checkpoint to"));
    }
}

TEST_F(CheckpointTest, AnIntegratorWithoutStateIsRefusedBeforeRendering) {
    const RunResult result = run({"--checkpoint", "check", "--integrator", "sleeper",
                                  "--plugin-path", kTroublesome, "--passes", "1"});
    EXPECT_EQ(result.exit_code, kRefused) << result.err;
    EXPECT_THAT(result.err, HasSubstr("\"sleeper\" can't be saved to 'check': this integrator "
                                      "can't be checkpointed"));
}

TEST_F(CheckpointTest, OptionsNeedAFile) {
    EXPECT_EQ(run({"--resume"}).exit_code, 2);
    EXPECT_EQ(run({"--checkpoint-interval", "3"}).exit_code, 2);
    EXPECT_EQ(run({"--checkpoint", "check", "--checkpoint-interval", "-1"}).exit_code, 2);
}

}  // namespace
}  // namespace lxs::test::checkpoint_test
