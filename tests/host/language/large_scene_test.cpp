// Inline arrays of millions of numbers: read right; the time is reported, not judged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "scene_fakes.h"
#include "temporary_folder.h"

namespace lxs::test::large_scene_test {
namespace {

std::string grid_mesh(int side) {
    std::string text = "Shape \"trianglemesh\" \"point P\" [\n";
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            text += std::to_string(x * 0.125) + " " + std::to_string(y * -0.25) + " 1.5\n";
        }
    }
    text += "] \"integer indices\" [\n";
    for (int y = 0; y + 1 < side; ++y) {
        for (int x = 0; x + 1 < side; ++x) {
            const int a = y * side + x;
            for (const int i : {a, a + 1, a + side, a + 1, a + side + 1, a + side}) {
                text += std::to_string(i);
                text += ' ';
            }
            text += '\n';
        }
    }
    return text + "]\n";
}

TEST(LargeScene, MillionsOfInlineNumbers) {
    constexpr int kSide = 600;
    const std::string world = grid_mesh(kSide);
    const auto begin = std::chrono::steady_clock::now();
    const SceneContents contents = read_world(world);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const auto& mesh = std::get<TriangleMesh>(contents.primitives.at(0).geometry);
    ASSERT_EQ(mesh.positions.size(), static_cast<std::size_t>(kSide) * kSide);
    ASSERT_EQ(mesh.indices.size(), static_cast<std::size_t>(kSide - 1) * (kSide - 1) * 6);
    EXPECT_EQ(mesh.positions.back(), Vec3(599 * 0.125f, 599 * -0.25f, 1.5f));
    EXPECT_EQ(mesh.indices.back(), static_cast<std::uint32_t>(kSide * (kSide - 1) + kSide - 2));
    const auto count = static_cast<double>(mesh.positions.size() * 3 + mesh.indices.size());
    std::cout << "[  report  ] " << count / 1e6 << " million numbers in " << elapsed.count()
              << " s\n";
}

/// Keeps what is said without its place, which takes time to find.
class Said final : public Diagnostics {
  public:
    void warning(const SourceLocation&, const std::string& message) override {
        messages.push_back(message);
    }
    void unknown_parameter(const SourceLocation&, const std::string& message) override {
        messages.push_back(message);
    }
    void fallback(const SourceLocation&, const std::string& message, const std::string&) override {
        messages.push_back(message);
    }
    std::vector<std::string> messages;
};

/// Time that grows with the product of both numbers would be minutes.
TEST(LargeScene, ThousandsOfUnknownNamesBesideThousandsOfKnownOnes) {
    constexpr int kNames = 12000;
    constexpr double kSeconds = 5;
    const struct {
        std::string noun, define, use;
    } cases[] = {
        {"named material", "MakeNamedMaterial \"KNOWN\" \"string type\" [\"matte\"]",
         "NamedMaterial \"NAME\""},
        {"named volume", "MakeNamedVolume \"KNOWN\" \"clear\"", "Interior \"NAME\""},
        {"object", "ObjectBegin \"KNOWN\" ObjectEnd", "ObjectInstance \"NAME\""},
        {"coordinate system", "CoordinateSystem \"KNOWN\"", "CoordSysTransform \"NAME\""},
        {"color texture", "Texture \"KNOWN\" \"color\" \"constant\"",
         "Material \"matte\" \"texture Kd\" [\"NAME\"]"},
    };
    for (const auto& [noun, define, use] : cases) {
        const auto named = [](std::string text, const char* place, const std::string& name) {
            return text.replace(text.find(place), std::string(place).size(), name) + "\n";
        };
        std::string world;
        for (int i = 0; i < kNames; ++i)
            world += named(define, "KNOWN", "known_material_" + std::to_string(100000 + i));
        for (int i = 0; i < kNames; ++i)
            world += named(use, "NAME", "unknown_stuff_" + std::to_string(100000 + i));
        Said said;
        const auto begin = std::chrono::steady_clock::now();
        read_scene_text("WorldBegin\n" + world + "WorldEnd\n", "test.lxs", ".", fake_registry(),
                        said);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(elapsed.count(), kSeconds) << noun;
        ASSERT_EQ(said.messages.size(), std::size_t{kNames}) << noun;
        EXPECT_THAT(said.messages.front(),
                    testing::AllOf(testing::HasSubstr("unknown " + noun +
                                                      " \"unknown_stuff_100000\"; known: "),
                                   testing::HasSubstr("known_material_100000, ")));
    }
}

/// What is told of many is told by the first.
TEST(LargeScene, TheFirstUnknownNamesAreToldWithTheNearest) {
    std::string world;
    for (int i = 0; i < 30; ++i)
        world +=
            "MakeNamedMaterial \"m" + std::to_string(100 + i) + "\" \"string type\" [\"matte\"]\n";
    for (int i = 0; i < 30; ++i)
        world += "NamedMaterial \"n" + std::to_string(100 + i) + "\"\n";
    world += "Interior \"m100\"\n";
    LenientDiagnostics diagnostics;
    read_world(world, diagnostics);
    EXPECT_THAT(diagnostics.messages.front(), testing::HasSubstr("did you mean \"m100\"?"));
    EXPECT_THAT(diagnostics.messages[7], testing::HasSubstr("did you mean \"m107\"?"));
    EXPECT_THAT(diagnostics.messages[29],
                testing::HasSubstr("unknown named material \"n129\"; it is ignored"));
    EXPECT_THAT(diagnostics.messages[30],
                testing::HasSubstr("unknown named volume \"m100\"; none is known"));
}

/// Listing the folder for each of them would take half a minute.
TEST(LargeScene, ThousandsOfMissingFilesInAFolderOfThousands) {
    constexpr int kFiles = 3000;
    const files::TemporaryFolder folder;
    std::string text = "WorldBegin\n";
    for (int i = 0; i < kFiles; ++i)
        folder.write("maps/here_" + std::to_string(i), "");
    folder.write("maps/There_7.png", "");
    for (int i = 0; i < kFiles; ++i)
        text += "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"maps/there_" +
                std::to_string(i) + ".png\"]\n";
    const std::string path = folder.write("scene.lxs", text + "WorldEnd\n");
    LenientDiagnostics diagnostics;
    const auto begin = std::chrono::steady_clock::now();
    read_scene(path, fake_registry(), diagnostics);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(elapsed.count(), 8);
    EXPECT_THAT(diagnostics.messages,
                testing::Contains(testing::HasSubstr("of other letter case; that one is read")));
}

TEST(LargeScene, TheTextOfLargeFilesAloneIsGivenUp) {
    const files::TemporaryFolder folder;
    folder.write("large.lxo", "#" + std::string(kMostKeptText, '-') + "\nShape \"sphere\"\n");
    const std::string path = folder.write(
        "scene.lxs", "WorldBegin\nShape \"sphere\"\nInclude \"large.lxo\"\nWorldEnd\n");
    CollectingDiagnostics diagnostics;
    ReadFiles files;
    const SceneContents contents = read_scene(path, fake_registry(), diagnostics, &files);
    EXPECT_EQ(files.sources.size(), 2u);
    forget_sources(files);
    EXPECT_TRUE(files.sources.empty());
    EXPECT_GT(contents.primitives.at(0).where.file->text->size(), 0u);
    EXPECT_EQ(contents.primitives.at(1).where.file->text->size(), 0u);
    EXPECT_EQ(contents.primitives.at(1).where.line, 2u);
}

TEST(LargeScene, LongListsReadAsShortOnesDo) {
    // From the 17th number on lists are read without the grammar.
    const std::string twenty = "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 ";
    const auto heights = [&](const std::string& more) {
        const SceneContents contents =
            read_world("Shape \"trianglemesh\" \"integer triindices\" [0 1 2] \"point P\" [" +
                       twenty + more + "]");
        return std::get<TriangleMesh>(contents.primitives.at(0).geometry).positions;
    };
    const std::vector<Vec3> read =
        heights("-20.5 # a comment 5\n+21 .5 1.e1\t123456789012345678 -0 1e-60 007\r\n2.5e+3 8.");
    ASSERT_EQ(read.size(), 10u);
    EXPECT_EQ(read[6], Vec3(18, 19, -20.5f));
    EXPECT_EQ(read[7], Vec3(21, 0.5f, 10));
    EXPECT_EQ(read[8], Vec3(123456789012345678.0f, 0, 0));
    EXPECT_EQ(read[9], Vec3(7, 2500, 8));
    const auto error = [&](const std::string& more) {
        return error_of_world("Shape \"trianglemesh\" \"point P\" [" + twenty + "\n" + more + "]");
    };
    EXPECT_NE(error("1 2 nan 4").find("trianglemesh: \"P\" takes finite numbers"),
              std::string::npos);
    EXPECT_EQ(error("1 2 3x"), "test.lxs:3:5: error: \"3x\" is not a number");
    EXPECT_EQ(error("1 -"), "test.lxs:3:3: error: \"-\" is not a number");
    EXPECT_EQ(
        error("1 \"two\""),
        "test.lxs:3:3: error: a list holds either numbers or strings or bools, not a mixture");
}

TEST(LargeScene, ManyStatementsOnOneLine) {
    std::string world;
    for (int i = 0; i < 200000; ++i)
        world += "Identity ";
    EXPECT_EQ(error_of_world(world + "Shape \"sphere\""), "");
}

}  // namespace
}  // namespace lxs::test::large_scene_test
