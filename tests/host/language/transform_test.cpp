// Transform statements: conventions, scopes, coordinate systems, motion, singular matrices.
#include <cmath>

#include <gtest/gtest.h>

#include "scene_fakes.h"

namespace lxs::test::transform_test {
namespace {

using Point = Imath::V3d;

Matrix transform_after(const std::string& statements) {
    const SceneContents contents = read_world(statements + "\nShape \"sphere\"");
    return std::get<Quadric>(contents.primitives.back().geometry).to_world;
}

Point mapped(const std::string& statements, const Point& p) {
    return p * transform_after(statements);
}

void expect_near(const Point& a, const Point& b) {
    EXPECT_LT((a - b).length(), 1e-12) << a << " instead of " << b;
}

TEST(Transform, AppliesTheLastStatementFirst) {
    expect_near(mapped("Translate 1 2 3\nScale 2 3 4", Point(1, 1, 1)), Point(3, 5, 7));
    expect_near(mapped("Scale 2 3 4\nTranslate 1 2 3", Point(1, 1, 1)), Point(4, 9, 16));
}

TEST(Transform, RotatesCounterClockwise) {
    expect_near(mapped("Rotate 90 0 0 1", Point(1, 0, 0)), Point(0, 1, 0));
    expect_near(mapped("Rotate 90 2 0 0", Point(0, 1, 0)), Point(0, 0, 1));
    expect_near(mapped("Rotate -360030 0 1 0", Point(1, 0, 0)),
                mapped("Rotate -30 0 1 0", Point(1, 0, 0)));
}

TEST(Transform, MatricesAreListedByColumn) {
    const std::string matrix = "[0 1 0 0  -1 0 0 0  0 0 1 0  5 6 7 1]";
    expect_near(mapped("Translate 9 9 9\nTransform " + matrix, Point(1, 0, 0)), Point(5, 7, 7));
    expect_near(mapped("Translate 1 0 0\nConcatTransform " + matrix, Point(1, 0, 0)),
                Point(6, 7, 7));
    expect_near(mapped("Transform [2 0 0 0  0 2 0 0  0 0 2 0  2 4 6 2]", Point(1, 1, 1)),
                Point(2, 3, 4));
}

TEST(Transform, LookAtPutsTheCameraAtTheOriginLookingAlongZ) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "LookAt 0 -4 1  0 -3 1  0 0 1 Camera \"perspective\" WorldBegin WorldEnd", diagnostics);
    const Matrix& to_camera = contents.options.at("Camera").transform;
    expect_near(Point(0, -4, 1) * to_camera, Point(0, 0, 0));
    expect_near(Point(0, 0, 1) * to_camera, Point(0, 0, 4));
    expect_near(Point(1, -4, 1) * to_camera, Point(1, 0, 0));  // world right is image right
    expect_near(Point(0, -4, 2) * to_camera, Point(0, 1, 0));
}

TEST(Transform, CoordinateSystemsAreNamed) {
    expect_near(mapped("Translate 1 2 3 CoordinateSystem \"a\" Identity CoordSysTransform \"a\"",
                       Point(0, 0, 0)),
                Point(1, 2, 3));
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "Translate 1 2 3 Camera \"perspective\" WorldBegin CoordSysTransform \"camera\" "
        "Shape \"sphere\" CoordSysTransform \"world\" Shape \"sphere\" WorldEnd",
        diagnostics);
    const auto origin = [&](std::size_t i) {
        return std::get<Quadric>(contents.primitives.at(i).geometry).to_world.translation();
    };
    expect_near(origin(0), Point(-1, -2, -3));
    expect_near(origin(1), Point(0, 0, 0));
    EXPECT_EQ(error_of_world("CoordSysTransform \"wrld\""),
              "test.lxs:2:19: error: unknown coordinate system \"wrld\"; did you mean \"world\"? "
              "Known: world");
}

TEST(Transform, WorldBeginResets) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents =
        read_text("Scale 2 2 2 WorldBegin Shape \"sphere\" WorldEnd", diagnostics);
    EXPECT_EQ(std::get<Quadric>(contents.primitives.at(0).geometry).to_world, Matrix());
}

TEST(Transform, ScopesRestore) {
    expect_near(mapped("TransformBegin Scale 2 2 2 TransformEnd", Point(1, 1, 1)), Point(1, 1, 1));
    expect_near(mapped("AttributeBegin Scale 2 2 2 AttributeEnd", Point(1, 1, 1)), Point(1, 1, 1));
}

TEST(Transform, TinyAndHugeScalesAreNotSingular) {
    EXPECT_EQ(error_of_world("Scale 1e-12 1e-12 1e-12"), "");
    EXPECT_EQ(error_of_world("Scale 1e12 1 1e-12"), "");
}

TEST(Transform, SingularOnesAreErrors) {
    const std::string singular =
        "test.lxs:2:1: error: the transform is singular: it flattens space";
    EXPECT_EQ(error_of_world("Scale 1 0 1"), singular);
    EXPECT_EQ(error_of_world("Transform [1 0 0 0  1 0 0 0  0 0 1 0  0 0 0 1]"), singular);
    EXPECT_EQ(error_of_world("Transform [1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 0]"),
              "test.lxs:2:1: error: the matrix maps space to infinity (last number 0)");
    EXPECT_EQ(error_of_world("Transform [1 0 0 1  0 1 0 0  0 0 1 0  0 0 0 1]"),
              "test.lxs:2:1: error: the matrix is projective (numbers 4, 8 and 12 must be 0); "
              "translation stands in numbers 13 to 15");
    EXPECT_EQ(error_of_world("Rotate 10 0 0 0"),
              "test.lxs:2:1: error: Rotate about an axis of length 0");
    EXPECT_EQ(error_of_world("LookAt 1 1 1  1 1 1  0 0 1"),
              "test.lxs:2:1: error: LookAt: eye and target are one point");
    EXPECT_EQ(error_of_world("LookAt 0 0 0  0 0 1  0 0 0"),
              "test.lxs:2:1: error: LookAt: the up vector has length 0");
    EXPECT_EQ(error_of_world("LookAt 0 0 0  0 0 1  0 0 5"),
              "test.lxs:2:1: error: LookAt: the up vector is parallel to the view direction");
    EXPECT_EQ(error_of_world("Scale 1e38 1 1\nScale 1e38 1 1"),
              "test.lxs:3:1: error: the transform's numbers grow beyond 3.4e38");
}

TEST(Motion, ShapesStayWhereItBeginsAndAWarningSaysSo) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_world(
        "Translate 1 0 0\nMotionBegin [0 1]\nTranslate 0 2 0\nTranslate 0 5 0\nMotionEnd\n"
        "Shape \"sphere\"",
        diagnostics);
    expect_near(std::get<Quadric>(contents.primitives.at(0).geometry).to_world.translation(),
                Point(1, 2, 0));
    EXPECT_EQ(diagnostics.messages,
              (std::vector<std::string>{
                  "test.lxs:7:1: warning: only ObjectInstance and Camera move: this "
                  "shape stays where its motion begins"}));
}

TEST(Motion, InstancesKeepTheirKeysThroughLaterTransforms) {
    const SceneContents contents = read_world(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd\nTranslate 1 0 0\n"
        "MotionBegin [0.5 2]\nTranslate 0 2 0\nIdentity\nMotionEnd\nTranslate 0 0 3\n"
        "AttributeBegin Identity ObjectInstance \"o\" AttributeEnd ObjectInstance \"o\"");
    EXPECT_TRUE(contents.instances.at(0).motion.empty());
    const Motion& motion = contents.instances.at(1).motion;
    ASSERT_EQ(motion.size(), 2u);
    EXPECT_EQ(motion[0].time, 0.5);
    EXPECT_EQ(motion[1].time, 2);
    expect_near(motion[0].matrix.translation(), Point(1, 2, 3));
    expect_near(motion[1].matrix.translation(), Point(0, 0, 3));
    expect_near(contents.instances.at(1).to_world.translation(), Point(1, 2, 3));
}

TEST(Motion, NestedInstancesMoveWithBoth) {
    const SceneContents contents = read_world(
        "ObjectBegin \"a\" Shape \"sphere\" ObjectEnd\n"
        "ObjectBegin \"b\" MotionBegin [0 1] Identity Translate 2 0 0 MotionEnd "
        "ObjectInstance \"a\" ObjectEnd\n"
        "MotionBegin [0 2] Identity Translate 0 4 0 MotionEnd ObjectInstance \"b\"");
    const Motion& motion = contents.instances.at(0).motion;
    ASSERT_EQ(motion.size(), 3u);
    expect_near(motion[1].matrix.translation(), Point(2, 2, 0));
    expect_near(motion[2].matrix.translation(), Point(2, 4, 0));
}

TEST(Motion, ObjectsWithLightsStayAndSaySo) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_world(
        "ObjectBegin \"o\" AreaLightSource \"area\" Shape \"sphere\" ObjectEnd\n"
        "MotionBegin [0 1] Identity Translate 2 0 0 MotionEnd ObjectInstance \"o\"",
        diagnostics);
    EXPECT_TRUE(contents.instances.at(0).motion.empty());
    ASSERT_FALSE(diagnostics.messages.empty());
    EXPECT_NE(diagnostics.messages.back().find("holds lights and is moved"), std::string::npos);
}

TEST(Motion, TurnsAtAConstantRate) {
    Matrix turned;
    turned.rotate(Imath::V3d(0, 0, 1.2));
    const MotionPath path({{0, Matrix()}, {2, Matrix().setScale(Imath::V3d(3.0)) * turned}});
    const Matrix middle = path.at(1);
    Point image;
    middle.multDirMatrix(Point(1, 0, 0), image);
    expect_near(image, Point(2 * std::cos(0.6), 2 * std::sin(0.6), 0));
    EXPECT_EQ(path.at(-1), path.at(0)) << "stays before its first key";
    EXPECT_GE(path.steps(0, 2).size(), 14u) << "a turn of 69 degrees in steps of 5";
}

TEST(Motion, ChecksItsForm) {
    EXPECT_EQ(error_of_world("MotionBegin [0 1]\nIdentity\nMotionEnd"),
              "test.lxs:2:1: error: MotionBegin lists 2 times, but 1 transforms follow");
    EXPECT_EQ(error_of_world("MotionBegin [0 1]\nShape \"sphere\""),
              "test.lxs:3:1: error: Shape between MotionBegin and MotionEnd: only transforms");
    EXPECT_EQ(error_of_world("MotionEnd"), "test.lxs:2:1: error: MotionEnd without MotionBegin");
    EXPECT_EQ(error_of_world("MotionBegin [0 1] Identity Identity Identity"),
              "test.lxs:2:37: error: MotionBegin lists 2 times, but more transforms follow");
    EXPECT_EQ(error_of_world("MotionBegin [1 0]"),
              "test.lxs:2:1: error: MotionBegin takes ascending times, but 0 comes after 1");
    EXPECT_EQ(error_of_world("MotionBegin []"),
              "test.lxs:2:1: error: MotionBegin takes at least one time");
    EXPECT_EQ(error_of_world("MotionBegin [0 1] Identity Translate nan 0 0"),
              "test.lxs:2:38: error: Translate takes finite numbers, at most 3.4e38");
}

}  // namespace
}  // namespace lxs::test::transform_test
