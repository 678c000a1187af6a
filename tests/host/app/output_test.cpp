// Protects the outputs: their names, that they appear whole or not at all, and that a place that
// can't be written is found before rendering.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::output_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class OutputTest : public testing::Test {
  protected:
    OutputTest() { folder_.write("scene.lxs", small_scene()); }
    RunResult run(std::vector<std::string> options) {
        options.insert(options.begin(), {"scene.lxs", "--passes", "2"});
        return run_lxsrender(folder_, std::move(options));
    }
    TemporaryFolder folder_;
};

TEST_F(OutputTest, NamesComeFromTheFilmOrFromTheCommandLine) {
    EXPECT_EQ(run({}).exit_code, 0);
    EXPECT_TRUE(folder_.has("out.exr"));
    EXPECT_TRUE(folder_.has("out.png"));
    EXPECT_EQ(run({"-o", "other.exr"}).exit_code, 0);
    EXPECT_TRUE(folder_.has("other.exr"));
    EXPECT_TRUE(folder_.has("other.png"));
}

TEST_F(OutputTest, ANameOfAPngMeansThePngAlone) {
    EXPECT_EQ(run({"-o", "other.exr"}).exit_code, 0);
    const RunResult result = run({"-o", "alone.PNG"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("wrote alone.PNG\n"));
    EXPECT_EQ(folder_.read("alone.PNG"), folder_.read("other.png"));
    EXPECT_EQ(folder_.entries(), 4u);  // scene, EXR, two PNGs
}

TEST_F(OutputTest, ExposureIsThePngsAlone) {
    for (const char* stops : {"0", "1", "-60"}) {
        const std::string name = std::string("by") + stops;
        ASSERT_EQ(run({"-o", name + ".exr", "--exposure", stops}).exit_code, 0);
        EXPECT_EQ(folder_.read(name + ".exr"), folder_.read("by0.exr"));
    }
    EXPECT_NE(folder_.read("by1.png"), folder_.read("by0.png"));
    EXPECT_THAT(run({"--exposure", "-60"}).err,
                HasSubstr("the image is all black; the likely reason: the exposure: luminances"));
}

TEST_F(OutputTest, NoTemporaryFilesStayBehind) {
    EXPECT_EQ(run({"--stats", "stats.json"}).exit_code, 0);
    EXPECT_EQ(folder_.entries(), 4u);  // scene, EXR, PNG, statistics
}

TEST_F(OutputTest, SameSceneAndSeedGiveTheSameFileForAnyNumberOfThreads) {
    ASSERT_EQ(run({"-o", "one.exr", "--threads", "1"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "two.exr", "--threads", "2"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "seven.exr", "--threads", "7"}).exit_code, 0);
    ASSERT_EQ(run({"-o", "seed.exr", "--seed", "5"}).exit_code, 0);
    EXPECT_EQ(folder_.read("one.exr"), folder_.read("two.exr"));
    EXPECT_EQ(folder_.read("one.exr"), folder_.read("seven.exr"));
    EXPECT_NE(folder_.read("one.exr"), folder_.read("seed.exr"));
}

TEST_F(OutputTest, UnwritablePlacesAreFoundBeforeRendering) {
    folder_.write("file", "");
    for (const char* name : {"loop.exr", "loop.png"})
        std::filesystem::create_symlink(name, folder_ / name);
    const std::string too_long(300, 'x');
    const struct {
        std::vector<std::string> options;
        std::string message;
    } cases[] = {
        {{"-o", "nowhere/a.exr"}, "error: cannot write 'nowhere/a.exr': No such file or directory"},
        {{"-o", "file/a.exr"}, "error: cannot write 'file/a.exr': Not a directory"},
        {{"-o", "/proc/a.exr"}, "error: cannot write '/proc/a.exr': "},
        {{"--stats", "nowhere/s.json"}, "error: cannot write 'nowhere/s.json': No such file"},
        {{"--stats", "."}, "error: cannot write '.': Is a directory"},
        {{"-o", too_long + ".exr"}, "error: cannot write '" + too_long + ".exr': File name too"},
        {{"--stats", too_long}, "error: cannot write '" + too_long + "': File name too long"},
        {{"--checkpoint", too_long}, "error: cannot write '" + too_long + "': File name too long"},
        {{"--learned-out", too_long}, "error: cannot write '" + too_long + "': File name too long"},
        {{"-o", "loop.exr"}, "error: cannot write 'loop.exr': Too many levels of symbolic links"},
        {{"-o", "loop.png"}, "error: cannot write 'loop.png': Too many levels of symbolic links"},
        {{"--stats", "loop.exr"}, "error: cannot write 'loop.exr': Too many levels of symbolic"},
    };
    for (const auto& [options, message] : cases) {
        const RunResult result = run(options);
        EXPECT_EQ(result.exit_code, 5) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_THAT(result.err, Not(HasSubstr("rendering")));
    }
}

TEST_F(OutputTest, NamesMayBeAsLongAsNamesCanBe) {
    for (const std::size_t length : {229, 240, 251}) {
        const std::string name(length, 'x');
        const RunResult result = run({"-o", name + ".exr", "--stats", name + ".jso"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        for (const char* suffix : {".exr", ".png", ".jso"})
            EXPECT_TRUE(folder_.has(name + suffix)) << length;
    }
}

class ApartTest : public OutputTest {
  protected:
    ApartTest() {
        folder_.write("scene.lxs",
                      small_scene("Include \"camera.lxo\"",
                                  "LightSource \"infinite\" \"string mapname\" [\"sky.png\"]\n"
                                  "Texture \"t\" \"color\" \"imagemap\" \"string filename\" "
                                  "[\"wood.png\"]\nMaterial \"matte\" \"texture Kd\" [\"t\"]\n"
                                  "Shape \"sphere\" \"float radius\" [0.5]"));
        folder_.write("camera.lxo", "Sampler \"random\"\n");
        const std::string picture = small_picture();
        for (const char* name : {"sky.png", "wood.png"})
            folder_.write(name, picture);
    }

    /// An image file.
    static std::string small_picture() {
        TemporaryFolder folder;
        folder.write("scene.lxs", small_scene());
        run_lxsrender(folder, {"scene.lxs", "--passes", "1"});
        return folder.read("out.png");
    }

    void expect_refused(const std::vector<std::string>& options, const std::string& message) {
        std::map<std::string, std::string> before, after;
        const auto look = [&](std::map<std::string, std::string>& files) {
            for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
                if (entry.is_regular_file())
                    files[entry.path()] = folder_.read(entry.path().filename().string());
            }
        };
        look(before);
        const RunResult result = run(options);
        look(after);
        EXPECT_EQ(result.exit_code, 5) << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: cannot write " + message + "\n"));
        EXPECT_EQ(before, after) << message;
    }
};

TEST_F(ApartTest, OutputsAreApart) {
    std::filesystem::create_directory(folder_ / "inner");
    std::filesystem::create_symlink("../out.exr", folder_ / "inner/link");
    expect_refused({"--stats", "out.exr"},
                   "the statistics to 'out.exr': it is the same file as the image 'out.exr'");
    expect_refused({"--stats", "./out.png"},
                   "the statistics to './out.png': it is the same file as the PNG 'out.png'");
    expect_refused({"--stats", "inner/../out.exr"},
                   "the statistics to 'inner/../out.exr': it is the same file as the image "
                   "'out.exr'");
    expect_refused({"--stats", "inner/link"},
                   "the statistics to 'inner/link': it is the same file as the image 'out.exr'");
    expect_refused({"--checkpoint", "out.exr"},
                   "the checkpoint to 'out.exr': it is the same file as the image 'out.exr'");
    expect_refused({"--stats", "a", "--learned-out", "a"},
                   "what is learned to 'a': it is the same file as the statistics 'a'");
    folder_.write("kept.exr", "older");
    std::filesystem::create_hard_link(folder_ / "kept.exr", folder_ / "same");
    expect_refused({"-o", "kept.exr", "--stats", "same"},
                   "the statistics to 'same': it is the same file as the image 'kept.exr'");
    EXPECT_EQ(run({"-o", "a.exr", "--stats", "A.EXR"}).exit_code, 0) << "two files here";
    EXPECT_EQ(run({"-o", "a.exr", "--stats", "/dev/null"}).exit_code, 0);
}

TEST_F(ApartTest, NothingThatIsReadIsWritten) {
    std::filesystem::create_hard_link(folder_ / "scene.lxs", folder_ / "twin");
    std::filesystem::create_symlink("camera.lxo", folder_ / "link.exr");
    for (const char* option : {"--stats", "--learned-out"}) {
        const std::string role = option[2] == 's' ? "the statistics" : "what is learned";
        expect_refused({option, "scene.lxs"},
                       role + " to 'scene.lxs': it is the same file as the scene 'scene.lxs'");
        expect_refused({option, "twin"},
                       role + " to 'twin': it is the same file as the scene 'scene.lxs'");
        expect_refused({option, "camera.lxo"},
                       role +
                           " to 'camera.lxo': it is the same file as the scene's file "
                           "'camera.lxo'");
    }
    expect_refused({"-o", "link.exr"},
                   "the image to 'link.exr': it is the same file as the scene's file 'camera.lxo'");
    expect_refused({"-o", "wood.png"},
                   "the PNG to 'wood.png': it is the same file as the scene's file 'wood.png'");
    expect_refused({"-o", "wood.exr"},
                   "the PNG to 'wood.png': it is the same file as the scene's file 'wood.png'");
    expect_refused({"--stats", "sky.png"},
                   "the statistics to 'sky.png': it is the same file as the scene's file "
                   "'sky.png'");
    EXPECT_EQ(run({"-o", "other.exr"}).exit_code, 0);
}

TEST_F(OutputTest, StatisticsHoldSettingsFactsTimesAndCounts) {
    ASSERT_EQ(run({"--stats", "stats.json", "--seed", "3", "--threads", "2"}).exit_code, 0);
    const auto json = nlohmann::json::parse(folder_.read("stats.json"));
    EXPECT_EQ(json["settings"]["integrator"], "path");
    EXPECT_EQ(json["settings"]["seed"], 3);
    EXPECT_EQ(json["scene"]["lights"], 1);
    EXPECT_EQ(json["scene"]["width"], 8);
    EXPECT_EQ(json["counts"]["passes"], 2);
    EXPECT_EQ(json["path"]["paths"], 2 * 8 * 6);
    EXPECT_EQ(json["path"]["refused contributions"], 0);
    EXPECT_GE(json["counts"]["rays"], 2 * 8 * 6);
    EXPECT_GT(json["peak memory bytes"], 1'000'000);
    for (const char* phase : {"load", "build", "render", "write"}) {
        EXPECT_TRUE(json["seconds"].contains(phase)) << phase;
    }
    EXPECT_FALSE(json["interrupted"]);
}

TEST_F(OutputTest, ExrHeaderHoldsHowItWasMade) {
    ASSERT_EQ(run({}).exit_code, 0);
    const std::string exr = folder_.read("out.exr");
    for (const char* key : {"integrator", "passes", "seed", "scene", "software"}) {
        EXPECT_THAT(exr, HasSubstr(key));
    }
    EXPECT_THAT(exr, Not(HasSubstr("relMSE")));  // two passes don't tell
    ASSERT_EQ(run_lxsrender(folder_, {"scene.lxs", "--passes", "3"}).exit_code, 0);
    for (const char* key : {"relMSE", "relMSEInterval", "relMSEWhole", "RMSE", "RMSEInterval"}) {
        EXPECT_THAT(folder_.read("out.exr"), HasSubstr(key));
    }
}

}  // namespace
}  // namespace lxs::test::output_test
