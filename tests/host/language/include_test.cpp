// Include: where files are found, chains in messages, cycles, depth; standard input.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

#include "scene_fakes.h"
#include "temporary_folder.h"

namespace lxs::test::include_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class Include : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    std::string path(const std::string& name) const { return folder_ / name; }
    SceneContents read(const std::string& name) const {
        CollectingDiagnostics diagnostics;
        return read_scene(path(name), fake_registry(), diagnostics);
    }
    /// The error's text with the test's folder shown as "@".
    std::string error_of(const std::string& name) const {
        std::string message;
        try {
            read(name);
        } catch (const InputError& error) {
            message = error.what();
        }
        const std::string folder = folder_.path().string();
        std::string shown;
        std::size_t from = 0;
        for (std::size_t at = message.find(folder); at != std::string::npos;
             at = message.find(folder, from)) {
            shown.append(message, from, at - from).push_back('@');
            from = at + folder.size();
        }
        return shown + message.substr(from);
    }

    files::TemporaryFolder folder_;
};

TEST_F(Include, FilesAreFoundInTheMainFolderThenByBasenameThenBesideTheIncluder) {
    write("main.lxs",
          "WorldBegin Include \"sub/a.lxo\" Include \"C:\\\\old\\\\place\\\\b.lxo\" "
          "Include \"/no/such/b.lxo\" WorldEnd");
    write("sub/a.lxo", "Shape \"sphere\" Include \"c.lxo\" Include \"b.lxo\"");
    write("sub/c.lxo", "Shape \"sphere\"");
    write("b.lxo", "Shape \"sphere\"");
    EXPECT_EQ(read("main.lxs").primitives.size(), 5u);
    EXPECT_EQ(read("main.lxs").directory, folder_.path().string());
}

TEST_F(Include, AssetsAreFoundLikeIncludes) {
    write("main.lxs", "WorldBegin Include \"sub/a.lxm\" WorldEnd");
    write("sub/a.lxm",
          "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"maps\\wood.png\"]");
    EXPECT_EQ(error_of("main.lxs"),
              "@/sub/a.lxm:1:32: error: no file \"maps\\wood.png\"; looked in \"@\" and beside the "
              "file that names it\n"
              "  Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"maps\\wood.png\"]\n"
              "                                 ^\n"
              "included from @/main.lxs:1");
    write("sub/maps/wood.png", "");
    EXPECT_EQ(error_of("main.lxs"), "");
}

/// A scene may name any file of whoever renders it, and messages show lines of scenes.
TEST_F(Include, WhatIsNoSceneIsNotShown) {
    write("main.lxs", "WorldBegin Include \"a.txt\" WorldEnd");
    for (const char* text : {"root:x:0:0:root", "# comment\n\nsecret = 1", "{", "\"Shape\"", "[1",
                             "1 2", "shape \"sphere\"",
                             "\x7f"
                             "ELF"}) {
        write("a.txt", text);
        EXPECT_EQ(error_of("main.lxs"),
                  "@/main.lxs:1:20: error: \"@/a.txt\" is no scene file: it does not begin with a "
                  "statement\n"
                  "  WorldBegin Include \"a.txt\" WorldEnd\n"
                  "                     ^");
    }
    for (const char* text :
         {"", "# comment", "\n", "\xEF\xBB\xBF# mark\nShape \"sphere\"", "Shape \"sphere\""}) {
        write("a.txt", text);
        EXPECT_EQ(error_of("main.lxs"), "");
    }
}

TEST_F(Include, SyntaxErrorsShowTheChain) {
    write("main.lxs", "WorldBegin\nInclude \"a.lxo\"\nWorldEnd\n");
    write("a.lxo", "\n\nInclude \"b.lxm\"");
    write("b.lxm", "MakeNamedMaterial \"m\"\n  \"color Kd\" [1 0 0");
    EXPECT_EQ(error_of("main.lxs"),
              "@/b.lxm:2:14: error: this list has no closing ']'\n"
              "    \"color Kd\" [1 0 0\n"
              "               ^\n"
              "included from @/a.lxo:3\n"
              "included from @/main.lxs:2");
}

TEST_F(Include, MissingFilesAreLocated) {
    write("main.lxs", "WorldBegin\n  Include \"none.lxo\"\nWorldEnd\n");
    EXPECT_EQ(
        error_of("main.lxs"),
        "@/main.lxs:2:11: error: no file \"none.lxo\"; looked in \"@\" and beside the file that "
        "names it\n"
        "    Include \"none.lxo\"\n"
        "            ^");
    write("main.lxs", "WorldBegin\n  Include \"\"\nWorldEnd\n");
    EXPECT_EQ(first_line(error_of("main.lxs")), "@/main.lxs:2:11: error: the file name is empty");
}

TEST_F(Include, MainFileMustBeReadable) {
    EXPECT_THROW(read("none.lxs"), std::system_error);
    fs::create_directories(folder_ / "folder.lxs");
    EXPECT_THROW(read("folder.lxs"), std::system_error);
}

TEST_F(Include, CyclesAreErrors) {
    write("main.lxs", "WorldBegin\nInclude \"a.lxo\"\nWorldEnd\n");
    write("a.lxo", "Include \"sub/../b.lxo\"");
    write("b.lxo", "Include \"./a.lxo\"");
    fs::create_directories(folder_ / "sub");
    const std::string message = error_of("main.lxs");
    EXPECT_NE(message.find("Include leads in a circle"), std::string::npos) << message;
    EXPECT_NE(message.find("a.lxo\" -> \""), std::string::npos) << message;
    EXPECT_EQ(message.substr(0, 10), "@/b.lxo:1:") << message;
}

TEST_F(Include, NestsThirtyTwoDeep) {
    write("main.lxs", "WorldBegin Include \"1.lxo\" WorldEnd\n");
    for (int i = 1; i < 32; ++i) {
        write(std::to_string(i) + ".lxo", "Include \"" + std::to_string(i + 1) + ".lxo\"");
    }
    write("32.lxo", "Shape \"sphere\"");
    EXPECT_EQ(read("main.lxs").primitives.size(), 1u);
    write("32.lxo", "Include \"33.lxo\"");
    write("33.lxo", "Shape \"sphere\"");
    EXPECT_EQ(first_line(error_of("main.lxs")),
              "@/32.lxo:1:9: error: Include nests deeper than 32 levels");
}

TEST_F(Include, WorldMayEndInAnIncludedFile) {
    write("main.lxs", "WorldBegin Include \"end.lxo\"");
    write("end.lxo", "WorldEnd");
    EXPECT_EQ(error_of("main.lxs"), "");
}

TEST(StandardInput, IsReadForADash) {
    std::istringstream scene("WorldBegin Shape \"sphere\" Shpae WorldEnd");
    std::streambuf* const saved = std::cin.rdbuf(scene.rdbuf());
    CollectingDiagnostics diagnostics;
    std::string message;
    try {
        read_scene("-", fake_registry(), diagnostics);
    } catch (const InputError& error) {
        message = first_line(error.what());
    }
    std::cin.rdbuf(saved);
    EXPECT_EQ(message,
              "<standard input>:1:27: error: unknown statement \"Shpae\"; did you mean Shape?");
}

}  // namespace
}  // namespace lxs::test::include_test
