// Graphics state: materials, volumes, light groups, area lights, orientation, scopes.
#include <gtest/gtest.h>

#include "scene_fakes.h"
#include "temporary_folder.h"
#include "textures_by_name.h"

namespace lxs::test::graphics_state_test {
namespace {

using Messages = std::vector<std::string>;

TEST(Materials, DefaultIsMatteAndMadeOnce) {
    const SceneContents contents = read_world("Shape \"sphere\" Shape \"sphere\"");
    EXPECT_EQ(fake(contents.primitives.at(0)).plugin(), "matte");
    EXPECT_EQ(contents.primitives[0].material, contents.primitives.at(1).material);
    EXPECT_EQ(contents.material_names, (Messages{"default"}));
}

TEST(Materials, OldAndNewStyle) {
    const SceneContents contents = read_world(
        "Texture \"red\" \"color\" \"constant\" \"color value\" [1 0 0]\n"
        "Material \"matte\" \"texture Kd\" \"red\"\nShape \"sphere\"\n"
        "MakeNamedMaterial \"blue\" \"color Kd\" [0 0 1] \"string type\" [\"matte\"]\n"
        "NamedMaterial \"blue\"\nShape \"sphere\"\n"
        "MakeNamedMaterial \"plain\"\nNamedMaterial \"plain\"\nShape \"sphere\"");
    EXPECT_EQ(fake(contents.primitives.at(0)).kd(), Rgb(1, 0, 0));
    EXPECT_EQ(fake(contents.primitives.at(1)).kd(), Rgb(0, 0, 1));
    EXPECT_EQ(fake(contents.primitives.at(2)).plugin(), "matte");
    EXPECT_EQ(contents.material_names, (Messages{"matte (test.lxs:3)", "blue", "plain"}));
    EXPECT_EQ(contents.primitives[1].material_index, 1u);
}

TEST(Materials, MixTakesNamedOnes) {
    const SceneContents contents = read_world(
        "MakeNamedMaterial \"a\" \"color Kd\" [0 1 0]\n"
        "Material \"mix\" \"string namedmaterial1\" [\"a\"]\nShape \"sphere\"");
    EXPECT_EQ(fake(contents.primitives.at(0)).plugin(), "mix of matte");
}

TEST(Materials, UnknownNamesAreErrors) {
    EXPECT_EQ(error_of_world("MakeNamedMaterial \"steel\"\nNamedMaterial \"stele\""),
              "test.lxs:3:15: error: unknown named material \"stele\"; did you mean \"steel\"? "
              "Known: steel");
    EXPECT_EQ(error_of_world("Material \"matte\" \"texture Kd\" [\"wood\"]"),
              "test.lxs:2:18: error: unknown color texture \"wood\"; none is known");
    EXPECT_EQ(error_of_world("Texture \"f\" \"float\" \"constant\"\n"
                             "Material \"matte\" \"texture Kd\" [\"f\"]"),
              "test.lxs:3:18: error: texture \"f\" is of type float, expected type color");
    EXPECT_EQ(
        error_of_world("Texture \"f\" \"colour\" \"constant\""),
        "test.lxs:2:13: error: unknown texture type \"colour\"; did you mean \"color\"? Known: "
        "color, float, fresnel");
    EXPECT_EQ(error_of_world("MakeNamedMaterial \"a\" \"float type\" [1]"),
              "test.lxs:2:23: error: the material's type is written \"string type\" [\"name\"]");
}

TEST(Materials, RedefinitionWarns) {
    CollectingDiagnostics diagnostics;
    read_world("MakeNamedMaterial \"a\"\nMakeNamedMaterial \"a\"", diagnostics);
    EXPECT_EQ(diagnostics.messages, (Messages{"test.lxs:3:19: warning: material \"a\" is defined "
                                              "again: uses below take this one"}));
}

TEST(Media, InteriorExteriorAndTheCamera) {
    const SceneContents contents = read_world(
        "MakeNamedVolume \"water\" \"clear\" \"float fresnel\" [1.33]\n"
        "MakeNamedVolume \"air\" \"clear\" \"float fresnel\" [1.0]\n"
        "AttributeBegin Interior \"water\" Exterior \"air\" Shape \"sphere\"\n"
        "Interior \"\" Shape \"sphere\" AttributeEnd\nShape \"sphere\"\nExterior \"air\"");
    EXPECT_FLOAT_EQ(contents.primitives.at(0).interior->index(), 1.33f);
    EXPECT_FLOAT_EQ(contents.primitives.at(0).exterior->index(), 1.0f);
    EXPECT_EQ(contents.primitives.at(1).interior, nullptr);
    EXPECT_EQ(contents.primitives.at(2).exterior, nullptr);
    EXPECT_EQ(contents.camera_medium, contents.primitives[0].exterior);
    EXPECT_EQ(error_of_world("Interior \"fog\""),
              "test.lxs:2:10: error: unknown named volume \"fog\"; none is known");
}

TEST(AreaLight, AppliesToLaterShapesInItsScope) {
    const SceneContents contents = read_world(
        "AttributeBegin\nLightGroup \"key\"\n"
        "AreaLightSource \"area\" \"color L\" [1 2 3] \"float gain\" [4] \"float power\" [5] "
        "\"float efficacy\" [6]\nShape \"sphere\"\nShape \"sphere\"\nAttributeEnd\n"
        "Shape \"sphere\"\nLightSource \"point\"");
    for (std::size_t i = 0; i < 2; ++i) {
        const std::optional<AreaEmission>& emission = contents.primitives.at(i).emission;
        ASSERT_TRUE(emission);
        EXPECT_EQ(emission->radiance->constant(), Rgb(1, 2, 3));
        EXPECT_EQ(emission->gain, 4);
        EXPECT_EQ(emission->power, 5);
        EXPECT_EQ(emission->efficacy, 6);
        EXPECT_EQ(emission->where.line, 4u);
        EXPECT_EQ(contents.light_groups.at(emission->group), "key");
    }
    EXPECT_FALSE(contents.primitives.at(2).emission);
    EXPECT_EQ(contents.light_groups.at(contents.lights.at(0).group), "default");
}

TEST(AreaLight, TakesATextureAndChecksItsName) {
    const SceneContents contents = read_world(
        "Texture \"t\" \"color\" \"constant\" \"color value\" [1 0 0]\n"
        "AreaLightSource \"area\" \"texture L\" [\"t\"] Shape \"sphere\"");
    EXPECT_EQ(contents.primitives.at(0).emission->radiance->constant(), Rgb(1, 0, 0));
    EXPECT_EQ(
        error_of_world("AreaLightSource \"aera\""),
        "test.lxs:2:17: error: unknown area light \"aera\"; did you mean \"area\"? Known: area");
    EXPECT_EQ(error_of_world("AreaLightSource \"area\" \"color L\" [1 -1 1]"),
              "test.lxs:2:24: error: an area light's L must not be negative");
}

TEST(AreaLight, ReadsItsProfileOnceForAllShapes) {
    const files::TemporaryFolder folder;
    const std::string lamp =
        folder.write("lamp.ies", "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 1\n");
    CollectingDiagnostics diagnostics;
    const SceneContents contents =
        read_world("Shape \"sphere\" AreaLightSource \"area\" \"string iesname\" [\"" + lamp +
                       "\"] Shape \"sphere\" Shape \"sphere\"",
                   diagnostics);
    EXPECT_EQ(diagnostics.messages, Messages{});
    EXPECT_NE(contents.primitives.at(1).emission->profile, nullptr);
    EXPECT_EQ(contents.primitives.at(1).emission->profile,
              contents.primitives.at(2).emission->profile);
    EXPECT_EQ(error_of_world("AreaLightSource \"area\" \"string iesname\" [\"none.ies\"]")
                  .find("test.lxs:2:24: error: "),
              0u);
}

TEST(Lights, KeepTransformGroupAndMedium) {
    const SceneContents contents = read_world(
        "MakeNamedVolume \"air\" \"clear\" Exterior \"air\" Translate 1 2 3 LightGroup \"sun\"\n"
        "LightSource \"sunsky\" \"vector sundir\" [0 0 1]");
    const LightDescription& light = contents.lights.at(0);
    EXPECT_EQ(light.parameters.plugin, "sunsky");
    EXPECT_EQ(light.parameters.values.at(0).name, "sundir");
    EXPECT_EQ(light.to_world.translation(), Imath::V3d(1, 2, 3));
    EXPECT_EQ(contents.light_groups, (Messages{"sun"}));
    EXPECT_NE(light.medium, nullptr);
}

// LuxRender reads their L as a texture, and exporters write blackbody ones.
TEST(Lights, TakeTheColourOfATexture) {
    const std::string texture = "Texture \"t\" \"color\" \"constant\" \"color value\" [1 0.5 0]\n";
    for (const char* light : {"point", "spot", "distant", "infinite"}) {
        const SceneContents contents =
            read_world(texture + "LightSource \"" + light + "\" \"texture L\" [\"t\"]");
        const ParameterValue& value = contents.lights.at(0).parameters.values.at(0);
        EXPECT_EQ(value.type, "color");
        EXPECT_EQ(std::get<std::vector<double>>(value.values), (std::vector<double>{1, 0.5, 0}));
    }
    EXPECT_EQ(
        error_of_world("LightSource \"point\" \"texture L\" [\"none\"]").find("test.lxs:2:21"), 0u);
}

TEST(Shapes, NameTheirDisplacementByAString) {
    ParameterSet set;
    set.values.push_back({"string", "displacementmap", std::vector<std::string>{"bumps"}, {}, {}});
    set.values.push_back({"string", "subdivscheme", std::vector<std::string>{"loop"}, {}, {}});
    name_displacement_as_texture(set);
    EXPECT_EQ(set.values.at(0).type, "texture");
    EXPECT_EQ(set.values.at(1).type, "string");
}

TEST(Lights, ThereIsAlwaysAGroup) {
    EXPECT_EQ(read_world("").light_groups, (Messages{"default"}));
}

TEST(Orientation, ReverseOrientationAndMirrorsToggle) {
    const SceneContents contents = read_world(
        "Shape \"sphere\"\nAttributeBegin ReverseOrientation Shape \"sphere\"\n"
        "Scale -1 1 1 Shape \"sphere\" AttributeEnd\nScale 1 -1 1 Shape \"sphere\"");
    const std::vector<bool> expected{false, true, false, true};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(contents.primitives.at(i).reverse_orientation, expected[i]) << i;
    }
}

TEST(Scopes, UnmatchedEndsAndBeginsAreToldAndGoneOnFrom) {
    LenientDiagnostics diagnostics;
    const SceneContents contents = read_world(
        "AttributeEnd\nTransformEnd\nAttributeBegin\nTransformBegin Translate 1 0 0\nAttributeEnd\n"
        "Shape \"sphere\"\nAttributeBegin",
        diagnostics);
    EXPECT_EQ(diagnostics.messages,
              (Messages{"test.lxs:2:1: warning: AttributeEnd without AttributeBegin; it is ignored",
                        "test.lxs:3:1: warning: TransformEnd without TransformBegin; it is ignored",
                        "test.lxs:5:1: warning: TransformBegin is not closed by TransformEnd; it "
                        "ends with what is around it",
                        "test.lxs:8:1: warning: AttributeBegin is not closed by AttributeEnd; it "
                        "ends with what is around it"}));
    EXPECT_EQ(std::get<Quadric>(contents.primitives.at(0).geometry).to_world, Matrix());
}

TEST(Scopes, NestDeeply) {
    std::string world;
    for (int i = 0; i < 9000; ++i)
        world += "AttributeBegin ";
    for (int i = 0; i < 9000; ++i)
        world += "AttributeEnd ";
    EXPECT_EQ(error_of_world(world), "");
}

}  // namespace
}  // namespace lxs::test::graphics_state_test
