// Objects and instances: space, scopes, nesting, inheritance, limits.
#include <gtest/gtest.h>

#include "scene_fakes.h"

namespace lxs::test::object_test {
namespace {

TEST(Objects, InstancesPlaceTheDefinition) {
    const SceneContents contents = read_world(
        "ObjectBegin \"o\" Translate 1 0 0 Shape \"sphere\" ObjectEnd\n"
        "AttributeBegin Translate 0 5 0 ObjectInstance \"o\" AttributeEnd\n"
        "AttributeBegin Translate 0 7 0 ObjectInstance \"o\" AttributeEnd");
    ASSERT_EQ(contents.objects.size(), 1u);
    EXPECT_TRUE(contents.primitives.empty());
    const auto& quadric = std::get<Quadric>(contents.objects[0].primitives.at(0).geometry);
    EXPECT_EQ(quadric.to_world.translation(), Imath::V3d(1, 0, 0));
    ASSERT_EQ(contents.instances.size(), 2u);
    EXPECT_EQ(contents.instances[0].object, 0u);
    EXPECT_EQ(contents.instances[1].to_world.translation(), Imath::V3d(0, 7, 0));
}

TEST(Objects, KeepTheirOwnScopes) {
    const SceneContents contents = read_world(
        "ObjectBegin \"o\"\nAttributeBegin Material \"matte\" \"color Kd\" [1 0 0] Scale 2 2 2 "
        "Shape \"sphere\" AttributeEnd\nShape \"sphere\"\nMaterial \"matte\" \"color Kd\" [0 1 0]\n"
        "ObjectEnd\nShape \"sphere\"\nObjectInstance \"o\"");
    const auto& primitives = contents.objects.at(0).primitives;
    EXPECT_EQ(fake(primitives.at(0)).kd(), Rgb(1, 0, 0));
    EXPECT_EQ(fake(primitives.at(1)).kd(), Rgb(0.9f));
    EXPECT_EQ(std::get<Quadric>(primitives[1].geometry).to_world, Matrix());
    EXPECT_EQ(fake(contents.primitives.at(0)).kd(), Rgb(0.9f));
}

TEST(Objects, EndsInsideCloseNothingOutside) {
    LenientDiagnostics diagnostics;
    const SceneContents contents = read_world(
        "AttributeBegin Translate 1 0 0\nObjectBegin \"o\"\nAttributeEnd\nShape \"sphere\"\n"
        "ObjectEnd\nShape \"sphere\"\nAttributeEnd",
        diagnostics);
    EXPECT_EQ(diagnostics.messages,
              (std::vector<std::string>{
                  "test.lxs:4:1: warning: AttributeEnd without AttributeBegin; it is ignored"}));
    EXPECT_EQ(std::get<Quadric>(contents.primitives.at(0).geometry).to_world.translation(),
              Imath::V3d(1, 0, 0));
}

TEST(Objects, Nest) {
    const SceneContents contents = read_world(
        "ObjectBegin \"leaf\" Shape \"sphere\" ObjectEnd\n"
        "ObjectBegin \"branch\" Translate 1 0 0 ObjectInstance \"leaf\"\n"
        "Translate 1 0 0 ObjectInstance \"leaf\" ObjectEnd\n"
        "Scale 2 2 2 ObjectInstance \"branch\"");
    ASSERT_EQ(contents.objects.size(), 1u);
    ASSERT_EQ(contents.instances.size(), 2u);
    EXPECT_EQ(Imath::V3d(0.0) * contents.instances[0].to_world, Imath::V3d(2, 0, 0));
    EXPECT_EQ(Imath::V3d(0.0) * contents.instances[1].to_world, Imath::V3d(4, 0, 0));
}

TEST(Objects, HaveTheNameOfTheOutermost) {
    const SceneContents contents = read_world(
        "ObjectBegin \"leaf\" Shape \"sphere\" ObjectEnd\n"
        "ObjectBegin \"branch\" ObjectInstance \"leaf\" ObjectEnd\n"
        "ObjectBegin \"tree\" Shape \"sphere\" ObjectInstance \"branch\" ObjectEnd\n"
        "ObjectInstance \"tree\" ObjectInstance \"leaf\" ObjectInstance \"branch\"");
    std::vector<std::string> names;
    for (const Instance& instance : contents.instances) {
        names.push_back(instance.outer == Instance::kNoOuterObject
                            ? contents.objects[instance.object].name
                            : contents.outer_objects.at(instance.outer));
    }
    EXPECT_EQ(names, (std::vector<std::string>{"tree", "tree", "leaf", "branch"}));
    EXPECT_EQ(contents.objects.size(), 2u);  // the leaf is kept once
}

TEST(Objects, InheritWhatTheyLack) {
    const SceneContents contents = read_world(
        "MakeNamedVolume \"water\" \"clear\"\n"
        "ObjectBegin \"o\" Shape \"sphere\"\n"
        "Material \"matte\" \"color Kd\" [0 0 1] Shape \"sphere\" ObjectEnd\n"
        "AttributeBegin Material \"matte\" \"color Kd\" [1 0 0] Interior \"water\"\n"
        "ObjectInstance \"o\" ObjectInstance \"o\" AttributeEnd\nObjectInstance \"o\"");
    ASSERT_EQ(contents.objects.size(), 2u);
    ASSERT_EQ(contents.instances.size(), 3u);
    EXPECT_EQ(contents.instances[0].object, contents.instances[1].object);
    const auto& dressed = contents.objects[contents.instances[0].object].primitives;
    EXPECT_EQ(fake(dressed.at(0)).kd(), Rgb(1, 0, 0));
    EXPECT_EQ(fake(dressed.at(1)).kd(), Rgb(0, 0, 1));
    EXPECT_NE(dressed.at(0).interior, nullptr);
    const auto& plain = contents.objects[contents.instances[2].object].primitives;
    EXPECT_EQ(fake(plain.at(0)).kd(), Rgb(0.9f));
    EXPECT_EQ(plain.at(0).interior, nullptr);
    EXPECT_EQ(contents.material_names.at(plain.at(0).material_index), "default");
}

TEST(Objects, CarryLights) {
    const SceneContents contents = read_world(
        "ObjectBegin \"o\" Translate 1 0 0 LightSource \"point\" ObjectEnd\n"
        "Translate 0 1 0 ObjectInstance \"o\"");
    EXPECT_EQ(contents.lights.at(0).to_world.translation(), Imath::V3d(1, 1, 0));
    EXPECT_TRUE(contents.objects.empty());
}

TEST(Objects, MotionInstanceGoesFromTheCurrentTransformToANamedOne) {
    const SceneContents contents = read_world(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd\nTranslate 3 0 0 CoordinateSystem \"end\"\n"
        "Identity MotionInstance \"o\" 0.25 1 \"end\"");
    const Motion& motion = contents.instances.at(0).motion;
    ASSERT_EQ(motion.size(), 2u);
    EXPECT_EQ(motion[0].time, 0.25);
    EXPECT_EQ(motion[0].matrix.translation(), Imath::V3d(0, 0, 0));
    EXPECT_EQ(motion[1].matrix.translation(), Imath::V3d(3, 0, 0));
    EXPECT_EQ(
        error_of_world("MotionInstance \"o\""),
        "test.lxs:2:1: error: MotionInstance takes \"object\" start end \"coordinate system\"");
}

TEST(Objects, Errors) {
    EXPECT_EQ(error_of_world("ObjectEnd"), "test.lxs:2:1: error: ObjectEnd without ObjectBegin");
    EXPECT_EQ(error_of_world("ObjectBegin \"o\""),
              "test.lxs:2:13: error: ObjectBegin is not closed by ObjectEnd");
    EXPECT_EQ(error_of_world("ObjectBegin \"a\" ObjectBegin \"b\""),
              "test.lxs:2:29: error: ObjectBegin inside of object \"a\"");
    EXPECT_EQ(error_of_world("ObjectBegin \"a\" ObjectInstance \"a\""),
              "test.lxs:2:32: error: object \"a\" holds itself");
    EXPECT_EQ(error_of_world("ObjectBegin \"tree\" ObjectEnd ObjectInstance \"three\""),
              "test.lxs:2:45: error: unknown object \"three\"; did you mean \"tree\"? Known: tree");
}

TEST(Objects, ExponentialNestingIsRefused) {
    std::string world = "ObjectBegin \"0\" Shape \"sphere\" ObjectEnd\n";
    for (int level = 1; level <= 60; ++level) {
        const std::string inner = "ObjectInstance \"" + std::to_string(level - 1) + "\" ";
        world += "ObjectBegin \"" + std::to_string(level) + "\" " + inner;
        world += inner + "ObjectEnd\n";
    }
    EXPECT_EQ(error_of_world(world + "ObjectInstance \"60\""),
              "test.lxs:63:16: error: more than ten million instances");
}

TEST(Objects, DeepNestingIsRefused) {
    std::string world = "ObjectBegin \"0\" ObjectEnd\n";
    for (int level = 1; level <= 100; ++level) {
        world += "ObjectBegin \"" + std::to_string(level) + "\" ObjectInstance \"" +
                 std::to_string(level - 1) + "\" ObjectEnd\n";
    }
    EXPECT_EQ(error_of_world(world), "test.lxs:66:13: error: objects nest deeper than 64");
}

}  // namespace
}  // namespace lxs::test::object_test
