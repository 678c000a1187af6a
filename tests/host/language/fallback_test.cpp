// What a scene asks for and LuxRender does not have: reading goes on as LuxRender does, with a
// message; errors do not end it either. Source of each fallback: LuxRender 1.9's core/context.cpp,
// core/dynload.cpp and core/paramset.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxs/language/asset_finder.h"
#include "scene_fakes.h"
#include "temporary_folder.h"

namespace lxs::test::fallback_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

struct Reading {
    LenientDiagnostics diagnostics;
    SceneContents contents;

    explicit Reading(const std::string& world)
        : contents(read_scene_text("WorldBegin\n" + world + "\nWorldEnd\n", "test.lxs", ".",
                                   fake_registry(), diagnostics)) {}
    const std::vector<std::string>& messages() const { return diagnostics.messages; }
    const Primitive& only() const { return contents.primitives.at(0); }
};

const Rgb kDefaultKd(0.9f);

TEST(Fallback, UnknownMaterialIsADefaultMatte) {
    const Reading reading("Material \"glas\" \"color Kd\" [1 0 0]\nShape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).plugin(), "matte");
    EXPECT_EQ(fake(reading.only()).kd(), kDefaultKd);
    EXPECT_THAT(reading.messages(),
                ElementsAre(StartsWith("test.lxs:2:10: warning: unknown material \"glas\"; did you "
                                       "mean \"glass\"?")));
    EXPECT_THAT(reading.messages().at(0), HasSubstr("; matte with its defaults is used"));
}

TEST(Fallback, NamedMaterialOfAnUnknownTypeIsADefaultMatte) {
    const Reading reading(
        "MakeNamedMaterial \"m\" \"string type\" [\"glas\"]\nNamedMaterial \"m\" Shape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).kd(), kDefaultKd);
    EXPECT_EQ(reading.messages().size(), 1u) << "what is unknown is said where it is, not again";
}

TEST(Fallback, MixOfAMaterialThatIsMissingIsADefaultMatte) {
    const Reading reading("Material \"mix\" \"string namedmaterial1\" [\"no\"]\nShape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).plugin(), "matte");
    EXPECT_THAT(reading.messages(),
                ElementsAre(StartsWith("test.lxs:2:16: warning: unknown named material \"no\"")));
}

TEST(Fallback, UnknownNamedMaterialLeavesTheOneInForce) {
    const Reading reading(
        "Material \"matte\" \"color Kd\" [1 0 0]\nNamedMaterial \"no\"\nShape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).kd(), Rgb(1, 0, 0));
    EXPECT_THAT(reading.messages(),
                ElementsAre("test.lxs:3:15: warning: unknown named material \"no\"; none is known; "
                            "it is ignored"));
}

/// LuxRender's wiki begins with this example, of whose texture only the float kind exists.
TEST(Fallback, FirstExampleOfTheWikiIsAGreyDisk) {
    LenientDiagnostics diagnostics;
    const SceneContents contents = read_scene_text(
        "LookAt 0 10 100 0 -1 0 0 1 0\n"
        "Camera \"perspective\" \"float fov\" [30]\n"
        "WorldBegin\n"
        "AttributeBegin\n"
        "CoordSysTransform \"camera\"\n"
        "LightSource \"distant\" \"point from\" [0 0 0] \"point to\" [0 0 1]\n"
        "AttributeEnd\n"
        "Rotate 135 1 0 0\n"
        "Texture \"checks\" \"color\" \"checkerboard\" \"float uscale\" [4] \"float vscale\" [4]\n"
        "  \"color tex1\" [1 0 0] \"color tex2\" [0 0 1]\n"
        "Material \"matte\" \"texture Kd\" \"checks\"\n"
        "Shape \"sphere\" \"float radius\" [20]\n"
        "WorldEnd\n",
        "test.lxs", ".", fake_registry(), diagnostics);
    EXPECT_EQ(fake(contents.primitives.at(0)).kd(), kDefaultKd);
    EXPECT_THAT(diagnostics.messages,
                ElementsAre(StartsWith(
                    "test.lxs:9:26: warning: unknown color texture \"checkerboard\"; known: ")));
    EXPECT_THAT(diagnostics.messages.at(0), HasSubstr("parameters that name it keep their"));
}

TEST(Fallback, TextureThatIsMissingOrOfAnotherTypeLeavesTheDefault) {
    const Reading missing("Material \"matte\" \"texture Kd\" [\"no\"] Shape \"sphere\"");
    EXPECT_EQ(fake(missing.only()).kd(), kDefaultKd);
    EXPECT_THAT(missing.messages(),
                ElementsAre("test.lxs:2:18: warning: unknown color texture \"no\"; none is known; "
                            "the parameter's default is used"));
    const Reading other(
        "Texture \"t\" \"float\" \"constant\"\nMaterial \"matte\" \"texture Kd\" [\"t\"]\n"
        "Shape \"sphere\"");
    EXPECT_EQ(fake(other.only()).kd(), kDefaultKd);
    EXPECT_THAT(other.messages(),
                ElementsAre("test.lxs:3:18: warning: texture \"t\" is of type float, expected type "
                            "color; the parameter's default is used"));
}

TEST(Fallback, ATextureThatCantBeMadeLeavesAnOlderOneOfItsName) {
    const Reading reading(
        "Texture \"t\" \"color\" \"constant\" \"color value\" [1 0 0]\n"
        "Texture \"t\" \"color\" \"no\"\n"
        "Material \"matte\" \"texture Kd\" [\"t\"] Shape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).kd(), Rgb(1, 0, 0));
}

TEST(Fallback, UnknownShapesAndVolumesAreLeftOut) {
    const Reading reading(
        "Shape \"sphera\"\nMakeNamedVolume \"v\" \"claer\"\nInterior \"v\"\nExterior \"w\"\n"
        "Shape \"sphere\"");
    EXPECT_EQ(reading.contents.primitives.size(), 1u);
    EXPECT_EQ(reading.only().interior, nullptr);
    EXPECT_THAT(reading.messages(), ElementsAre(HasSubstr("unknown shape \"sphera\""),
                                                HasSubstr("unknown volume \"claer\""),
                                                HasSubstr("unknown named volume \"w\"")));
}

TEST(Fallback, ParametersOfAWrongTypeKeepTheirDefault) {
    const Reading reading("Shape \"sphere\" \"string radius\" [\"big\"]");
    EXPECT_EQ(std::get<Sphere>(std::get<Quadric>(reading.only().geometry).shape).radius, 1);
    EXPECT_EQ(reading.messages().size(), 1u);
    const Reading misspelt("Shape \"sphere\" \"flaot radius\" [2] \"radius\" [3]");
    EXPECT_EQ(misspelt.contents.primitives.size(), 1u);
    EXPECT_THAT(misspelt.messages(),
                ElementsAre(HasSubstr("is given twice"),
                            HasSubstr("a parameter begins with \"type name\", found \"radius\"")));
}

TEST(Fallback, StatementsOutOfPlaceAreIgnored) {
    const Reading reading(
        "Camera \"perspective\"\nObjectEnd\nObjectInstance \"no\"\nMotionEnd\n"
        "CoordSysTransform \"no\"\nTexture \"t\" \"colour\" \"constant\"\n"
        "Include \"no.lxo\"\nShape \"sphere\"");
    EXPECT_EQ(reading.contents.primitives.size(), 1u);
    ASSERT_EQ(reading.messages().size(), 7u);
    for (const std::string& message : reading.messages()) {
        EXPECT_THAT(message, HasSubstr(": warning: "));
        EXPECT_THAT(message, testing::EndsWith("; it is ignored"));
    }
}

TEST(Fallback, AMotionOfWrongLengthIsIgnored) {
    const Reading reading(
        "Translate 1 0 0\nMotionBegin [0 1] Translate 5 0 0 MotionEnd\nShape \"sphere\"");
    EXPECT_EQ(reading.only().to_world[3][0], 1);
    EXPECT_EQ(reading.messages().size(), 1u);
}

TEST(Fallback, ErrorsDoNotEndTheReading) {
    const Reading reading(
        "Shapes \"sphere\"\nRotate 30 0 0 0\nMaterial \"glas\"\nScale 1 1\nShape \"sphere\"");
    EXPECT_EQ(reading.contents.primitives.size(), 1u);
    EXPECT_THAT(
        reading.messages(),
        ElementsAre("test.lxs:2:1: error: unknown statement \"Shapes\"; did you mean Shape?",
                    "test.lxs:3:1: error: Rotate about an axis of length 0",
                    StartsWith("test.lxs:4:10: warning: unknown material"),
                    "test.lxs:5:1: error: Scale takes 3 numbers, found 2"));
}

TEST(Fallback, BadSyntaxEndsItsFileOnly) {
    const files::TemporaryFolder folder;
    folder.write("main.lxs",
                 "WorldBegin Include \"a.lxo\"\nShapes \"x\"\nShape \"sphere\" WorldEnd");
    folder.write("a.lxo", "Shape \"sphere\" {");
    LenientDiagnostics diagnostics;
    const SceneContents contents = read_scene(folder / "main.lxs", fake_registry(), diagnostics);
    EXPECT_EQ(contents.primitives.size(), 2u) << "what comes before it, and after its file";
    EXPECT_THAT(diagnostics.messages,
                ElementsAre(HasSubstr("a.lxo:1:16: error: expected a statement, found \"{\""),
                            HasSubstr("main.lxs:2:1: error: unknown statement \"Shapes\"")));
}

TEST(Fallback, AFileOfOtherLetterCaseIsReadAndNamed) {
    const files::TemporaryFolder folder;
    folder.write(
        "main.lxs",
        "WorldBegin Include \"PARTS\\Ball.LXO\"\nInclude \"/old/place/Ring.lxo\" WorldEnd");
    std::filesystem::create_directory(folder / "parts");
    folder.write("parts/ball.lxo", "Shape \"sphere\"");
    folder.write("ring.LXO", "Shape \"sphere\"");
    LenientDiagnostics diagnostics;
    const SceneContents contents = read_scene(folder / "main.lxs", fake_registry(), diagnostics);
    EXPECT_EQ(contents.primitives.size(), 2u);
    ASSERT_EQ(diagnostics.messages.size(), 2u);
    EXPECT_THAT(diagnostics.messages[0], HasSubstr("no file \"PARTS\\Ball.LXO\", but \""));
    EXPECT_THAT(diagnostics.messages[0], HasSubstr("parts/ball.lxo\", of other letter case"));
    EXPECT_THAT(diagnostics.messages[1], HasSubstr("ring.LXO\", of other letter case"));
}

TEST(Fallback, ATextureThatCantBeMadeDoesNotTakeItsName) {
    const Reading reading(
        "Texture \"t\" \"color\" \"no\"\nMaterial \"matte\" \"texture Kd\" [\"s\"]\n"
        "Texture \"t\" \"color\" \"constant\" \"color value\" [1 0 0]\n"
        "Material \"matte\" \"texture Kd\" [\"t\"] Shape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).kd(), Rgb(1, 0, 0));
    EXPECT_THAT(reading.messages(),
                ElementsAre(HasSubstr("unknown color texture \"no\""),
                            HasSubstr("unknown color texture \"s\"; none is known")));
}

/// LuxRender looks one string up; two are none.
TEST(Fallback, AMaterialOfTwoTypesIsMatte) {
    const Reading reading(
        "MakeNamedMaterial \"m\" \"string type\" [\"mix\" \"glass\"]\n"
        "NamedMaterial \"m\" Shape \"sphere\"");
    EXPECT_EQ(fake(reading.only()).plugin(), "matte");
    EXPECT_THAT(reading.messages(),
                ElementsAre(HasSubstr("\"string type\" [\"name\"]; matte is used")));
}

TEST(Fallback, WithoutItsEndAWorldIsToldOfAndReturned) {
    LenientDiagnostics diagnostics;
    const SceneContents contents =
        read_scene_text("Film \"fleximage\"\nWorldBegin\nLightSource \"point\"", "test.lxs", ".",
                        fake_registry(), diagnostics);
    EXPECT_EQ(contents.options.count("Film"), 1u);
    EXPECT_EQ(contents.lights.size(), 1u);
    EXPECT_THAT(diagnostics.messages,
                ElementsAre(HasSubstr("error: the scene ends without WorldEnd")));
}

TEST(Fallback, VeryManyErrorsEndTheReading) {
    std::string world;
    for (int i = 0; i < 20000; ++i)
        world += "Scale 1\n";
    LenientDiagnostics diagnostics;
    try {
        read_scene_text("WorldBegin\n" + world + "WorldEnd", "test.lxs", ".", fake_registry(),
                        diagnostics);
        ADD_FAILURE() << "all was read";
    } catch (const EndOfReading& end) {
        EXPECT_EQ(end.message(), "more than 4999 errors: reading ends here");
        EXPECT_EQ(end.where().line, 5001u);
    }
    EXPECT_EQ(diagnostics.messages.size(), 5000u);
}

/// Finds `name` beside the scene of a folder; what is found is relative to the folder.
std::string found(const files::TemporaryFolder& folder, const std::string& name) {
    LenientDiagnostics diagnostics;
    try {
        const std::string path = AssetFinder(folder.path().string()).find(name, {}, diagnostics);
        return path.substr(folder.path().string().size() + 1);
    } catch (const InputError&) {
        return "";
    }
}

TEST(Fallback, OtherLetterCasesAreTriedUntilAFileIsFound) {
    namespace fs = std::filesystem;
    const files::TemporaryFolder folder;
    for (const char* name : {"TEXTURES", "textures", "Maps", "maps", "WOOD.png", "Bark.PNG"})
        fs::create_directory(folder / name);
    folder.write("textures/wood.jpg", "");
    EXPECT_EQ(found(folder, "Textures/wood.jpg"), "textures/wood.jpg");
    folder.write("maps/a.png", "");
    EXPECT_EQ(found(folder, "Maps/A.png"), "maps/a.png") << "the exact folder lacks it";
    folder.write("wood.png", "");
    EXPECT_EQ(found(folder, "Wood.png"), "wood.png") << "WOOD.png is a folder";
    fs::create_symlink("nowhere", folder / "BARK.png");
    folder.write("bark.png", "");
    EXPECT_EQ(found(folder, "bark.Png"), "bark.png") << "BARK.png leads nowhere";
}

TEST(Fallback, TheFolderAboveALinkIsThatOfItsTarget) {
    namespace fs = std::filesystem;
    const files::TemporaryFolder folder;
    fs::create_directories(folder / "far/maps");
    fs::create_symlink("far/maps", folder / "maps");
    for (const char* name : {"wood.png", "far/wood.png"})
        folder.write(name, "");
    EXPECT_EQ(found(folder, "maps/../Wood.png"), "maps/../wood.png") << "far/wood.png";
    EXPECT_EQ(found(folder, "maps/../wood.png"), "maps/../wood.png");
    EXPECT_EQ(found(folder, "far/../WOOD.png"), "wood.png");
}

}  // namespace
}  // namespace lxs::test::fallback_test
