// Protects: files that statements name are read ahead on several threads, each once, and messages
// stay those of the statements, in their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "files_ahead.h"
#include "run_on_threads.h"
#include "scene_fakes.h"
#include "temporary_folder.h"

namespace lxs::test::files_ahead_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Shapes "file", whose factory fails for empty files.
class FilesAhead : public testing::Test {
  protected:
    Registry registry() {
        Registry registry = fake_registry();
        registry.shapes["file"] = {
            {{"filename", ParameterType::String}},
            [this](const ParameterReader& reader, const AssetContext& assets, const Matrix& m) {
                const std::string path =
                    assets.resolve(reader.string("filename", ""), reader.where("filename"));
                const std::any ahead = assets.take_ahead(reader.plugin(), path);
                if (ahead.has_value()) ++taken_;
                if (!ahead.has_value() && read(path).empty())
                    reader.fail("filename", "an empty file");
                return Geometry(Quadric{Sphere{}, m});
            },
            [this](const std::string& path) {
                const std::string text = read(path);
                if (text.empty()) throw std::runtime_error("empty");
                return std::any(text);
            }};
        return registry;
    }
    SceneContents read_scene(const std::string& world, Diagnostics& diagnostics) {
        return lxs::read_scene_text("WorldBegin\n" + world + "WorldEnd\n", "scene.lxs",
                                    folder_.path().string(), registry(), diagnostics);
    }
    static std::string shape(const std::string& name) {
        return "Shape \"file\" \"string filename\" [\"" + name + "\"]\n";
    }

    files::TemporaryFolder folder_;
    std::atomic<int> read_{0}, taken_{0};

  private:
    std::string read(const std::string& path) {
        ++read_;
        return folder_.read(std::filesystem::path(path).filename().string());
    }
};

TEST_F(FilesAhead, EachIsReadOnce) {
    std::string world;
    for (int i = 0; i < 40; ++i)
        world += shape(folder_.write("f" + std::to_string(i), "text"));
    CollectingDiagnostics diagnostics;
    EXPECT_EQ(read_scene(world, diagnostics).primitives.size(), 40u);
    EXPECT_EQ(read_, 40);
    EXPECT_EQ(taken_, 40);
    EXPECT_TRUE(diagnostics.messages.empty());
}

TEST_F(FilesAhead, AFileThatIsNamedTwiceIsReadTwice) {
    folder_.write("one", "text");
    folder_.write("two", "text");
    CollectingDiagnostics diagnostics;
    const auto contents = read_scene(shape("one") + shape("two") + shape("one"), diagnostics);
    EXPECT_EQ(contents.primitives.size(), 3u);
    EXPECT_EQ(read_, 3);
}

/// Shapes before WorldBegin are no shapes: their files are kept for nobody.
TEST_F(FilesAhead, WhatNobodyTakesIsForgotten) {
    const Registry known = registry();
    AssetFinder finder(folder_.path().string());
    lxs::FilesAhead ahead(known, finder);
    const auto text = [](const std::string& value) {
        Argument argument;
        argument.values = std::vector<std::string>{value};
        return argument;
    };
    std::vector<Statement> statements;
    for (const std::string name : {"one", "two"}) {
        folder_.write(name, "text");
        Statement statement;
        statement.name = "Shape";
        statement.arguments = {text("file"), text("string filename"), text(name)};
        statements.push_back(statement);
    }
    ahead.read(statements);
    EXPECT_TRUE(ahead.take("file", (folder_.path() / "one").string()).has_value());
    ahead.forget();
    EXPECT_FALSE(ahead.take("file", (folder_.path() / "two").string()).has_value());
}

TEST_F(FilesAhead, MessagesComeInTheOrderOfStatementsForAnyNumberOfThreads) {
    std::string world;
    for (int i = 0; i < 30; ++i) {
        const bool empty = i == 7 || i == 23;
        const std::string name = folder_.write("f" + std::to_string(i), empty ? "" : "text");
        world += i == 12 ? "Shape \"nothing\"\n" : shape(i == 20 ? "missing" : name);
    }
    for (const unsigned threads : {1u, 8u}) {
        LenientDiagnostics diagnostics;
        const auto contents =
            concurrency::run_on(threads, [&] { return read_scene(world, diagnostics); });
        EXPECT_EQ(contents.primitives.size(), 26u);
        EXPECT_THAT(diagnostics.messages,
                    ElementsAre(HasSubstr("scene.lxs:9:14: warning: an empty file"),
                                HasSubstr("scene.lxs:14:7: warning: unknown shape \"nothing\""),
                                HasSubstr("scene.lxs:22:14: warning: "),
                                HasSubstr("scene.lxs:25:14: warning: an empty file")))
            << threads << " threads";
    }
}

TEST_F(FilesAhead, WhatStandsBeforeBadSyntaxIsReportedFirst) {
    LenientDiagnostics diagnostics;
    const std::string world = shape(folder_.write("empty", "")) + shape("missing") + "Shape [\n";
    EXPECT_THROW(read_scene(world, diagnostics), InputError);
    EXPECT_THAT(diagnostics.messages,
                ElementsAre(HasSubstr("scene.lxs:2:14"), HasSubstr("scene.lxs:3:14")));
}

}  // namespace
}  // namespace lxs::test::files_ahead_test
