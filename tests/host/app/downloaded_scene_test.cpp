// Protects whoever renders a scene of somebody else's: it writes below the current folder alone,
// what it names beside scenes is not told, and its text commands no terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "lxsrender_process.h"

namespace lxs::test::downloaded_scene_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class DownloadedScene : public testing::Test {
  protected:
    DownloadedScene() {
        fs::create_directories(here_ / "sub");
        fs::create_directories(there_);
    }

    /// In the folder `here_`, which is in one that is not to be written to.
    RunResult run(const std::string& scene, std::vector<std::string> more = {}) {
        outer_.write("here/scene.lxs", scene);
        more.insert(more.begin(), {"scene.lxs", "--passes", "1"});
        const fs::path here = here_;
        return LxsrenderProcess(outer_, more, "", [here] { fs::current_path(here); }).wait();
    }
    static std::string called(const std::string& name) {
        return small_scene(
            "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6]\n"
            "  \"string filename\" [\"" +
            name + "\"]");
    }
    bool made(const std::string& name) const { return outer_.has(name); }

    TemporaryFolder outer_;
    fs::path here_ = outer_ / "here", there_ = outer_ / "there";
};

TEST_F(DownloadedScene, WritesBelowTheCurrentFolderAlone) {
    const struct {
        std::string name, written;
        bool warned = true;
    } cases[] = {
        {"plain", "here/plain", false},
        {"sub/plain", "here/sub/plain", false},
        {"sub/../up", "here/up", false},
        {(there_ / "absolute").string(), "here/absolute"},
        {"../out", "here/out"},
        {"sub/../../there/far", "here/far"},
        {"C:\\\\renders\\\\win", "here/win"},
        {"..\\\\back", "here/back"},
        {"..", "here/luxout"},
    };
    for (const auto& [name, written, warned] : cases) {
        const RunResult result = run(called(name));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_TRUE(made(written + ".exr")) << name << result.err;
        EXPECT_TRUE(made(written + ".png")) << name;
        EXPECT_EQ(result.err.find("is not below the current folder") != std::string::npos, warned)
            << result.err;
    }
    EXPECT_TRUE(fs::is_empty(there_));
    EXPECT_EQ(outer_.entries(), 2u);
    EXPECT_EQ(run(called("../out"), {"-o", "../there/asked.exr"}).exit_code, 0);
    EXPECT_TRUE(made("there/asked.exr"));
}

/// A folder that is downloaded may hold links.
TEST_F(DownloadedScene, FollowsNoLinkOutOfTheCurrentFolder) {
    outer_.write("there/precious", "mine");
    fs::create_symlink("../there/precious", here_ / "file.exr");
    fs::create_symlink("../there", here_ / "folder");
    fs::create_symlink("../there/new.png", here_ / "dangling.png");
    fs::create_symlink("sub/inside.exr", here_ / "inside.exr");
    for (const char* name : {"file", "folder/a", "dangling"}) {
        const RunResult result = run(called(name));
        EXPECT_EQ(result.exit_code, 5) << result.err;
        EXPECT_THAT(result.err, HasSubstr("which the film names: links lead from there to '"));
    }
    EXPECT_EQ(outer_.read("there/precious"), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(there_), {}), 1);
    EXPECT_EQ(run(called("inside")).exit_code, 0);
    EXPECT_TRUE(made("here/sub/inside.exr"));
    EXPECT_EQ(run(called("x"), {"-o", "file.exr"}).exit_code, 0) << "as asked";
    EXPECT_NE(outer_.read("there/precious"), "mine");
}

TEST_F(DownloadedScene, ShowsNothingOfFilesThatAreNoScenes) {
    const std::string file = outer_.write("there/file", "");
    for (const char* text : {"secret:x:0:0:hidden\nsecret\n", "# secret\nhidden = secret\n",
                             "{\"secret\": 1}", "-----BEGIN secret-----\nhidden", "1.5 secret\n"}) {
        outer_.write("there/file", text);
        for (const char* use :
             {"Include \"FILE\"", "Shape \"plymesh\" \"string filename\" [\"FILE\"]",
              "Shape \"stlmesh\" \"string filename\" [\"FILE\"]",
              "Material \"metal\" \"string filename\" [\"FILE\"]",
              "Texture \"t\" \"color\" \"tabulateddata\" \"string filename\" [\"FILE\"]",
              "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"FILE\"]",
              "Texture \"t\" \"fresnel\" \"sopra\" \"string filename\" [\"FILE\"]",
              "Texture \"t\" \"fresnel\" \"luxpop\" \"string filename\" [\"FILE\"]",
              "LightSource \"point\" \"string iesname\" [\"FILE\"]",
              "LightSource \"infinite\" \"string mapname\" [\"FILE\"]"}) {
            std::string world = use;
            world.replace(world.find("FILE"), 4, file);
            const RunResult result = run(small_scene("", world));
            EXPECT_THAT(result.err, HasSubstr(file)) << use;
            EXPECT_THAT(result.err, Not(HasSubstr("secret"))) << use;
            EXPECT_THAT(result.err, Not(HasSubstr("hidden"))) << use;
        }
        const RunResult film = run(small_scene(
            "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6]\n"
            "  \"string cameraresponse\" [\"" +
            file + "\"]"));
        EXPECT_THAT(film.err, HasSubstr("it is no file of curves"));
        EXPECT_THAT(film.err, Not(HasSubstr("hidden")));
    }
}

TEST_F(DownloadedScene, CommandsNoTerminal) {
    const std::string escape = "\x1b[2J", next_line = "\xC2\x85",
                      c1 = "\xC2\x9B"
                           "31m",
                      bidi = "\xE2\x80\xAE", isolate = "\xE2\x81\xA6", bad = "\xFF\xC3(";
    const std::string name = "a" + next_line + c1 + bidi + isolate + bad + "\x7F" + "z";
    for (const std::string& world :
         {"NamedMaterial \"" + name + "\"", "Shape \"" + name + "\"",
          "Shape \"sphere\" \"float " + name + "\" [1]", "Include \"" + name + "\"",
          "Texture \"t\" \"" + name + "\" \"constant\"", "Shapes # " + escape + name,
          "LightGroup \"" + name + "\" LightSource \"point\"",
          "MakeNamedMaterial \"" + name + "\" \"string type\" [\"matte\"] NamedMaterial \"" + name +
              "\" Shape \"sphere\" \"float radius\" [0.5]"}) {
        const RunResult result = run(small_scene("", world), {"--explain", "--verbose"});
        for (const std::string& command :
             {escape, std::string("\x1b"), next_line, c1, bidi, isolate, std::string("\xFF"),
              std::string("\xC3("), std::string("\x7F")}) {
            EXPECT_THAT(result.err, Not(HasSubstr(command))) << world;
        }
    }
}

}  // namespace
}  // namespace lxs::test::downloaded_scene_test
