// Plugin names: unknown ones, and stand-ins for those that LuxRender knows and we don't render.
#include <gtest/gtest.h>

#include "scene_fakes.h"

namespace lxs::test::plugin_name_test {
namespace {

using Messages = std::vector<std::string>;

void expect_start(const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
}

TEST(PluginNames, UnknownOnesAreErrorsWithTheNearestFirst) {
    const std::string shape = error_of_world("Shape \"shpere\"");
    expect_start(shape,
                 "test.lxs:2:7: error: unknown shape \"shpere\"; did you mean \"sphere\"? Known: "
                 "sphere, barytrianglemesh, cone,");
    EXPECT_NE(shape.find("trianglemesh"), std::string::npos);
    expect_start(error_of_world("Material \"mate\""),
                 "test.lxs:2:10: error: unknown material \"mate\"; did you mean \"matte\"? Known: "
                 "matte, carpaint,");
    expect_start(error_of_world("MakeNamedMaterial \"m\"\n\"string type\" [\"glas\"]"),
                 "test.lxs:3:16: error: unknown material \"glas\"; did you mean \"glass\"?");
    expect_start(error_of_world("Texture \"t\" \"float\" \"imgemap\""),
                 "test.lxs:2:21: error: unknown float texture \"imgemap\"; did you mean "
                 "\"imagemap\"?");
    expect_start(error_of_world("MakeNamedVolume \"v\" \"claer\""),
                 "test.lxs:2:21: error: unknown volume \"claer\"; did you mean \"clear\"?");
}

TEST(PluginNames, ShapesAreLeftOut) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_world("Shape \"torus\"", diagnostics);
    EXPECT_TRUE(contents.primitives.empty());
    EXPECT_EQ(
        diagnostics.messages,
        (Messages{
            "test.lxs:2:7: warning: shape \"torus\" is not supported: the shape is skipped"}));
}

TEST(PluginNames, ShapesWithoutExtentAreSkipped) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents =
        read_world("Shape \"sphere\" \"float phimax\" [0]\nShape \"sphere\"", diagnostics);
    EXPECT_EQ(contents.primitives.size(), 1u);
    EXPECT_EQ(diagnostics.messages,
              (Messages{"test.lxs:2:16: warning: \"phimax\" is 0; the shape is skipped"}));
}

TEST(PluginNames, VolumeRegionsAreLeftOut) {
    CollectingDiagnostics diagnostics;
    read_world("Volume \"cloud\"", diagnostics);
    EXPECT_EQ(diagnostics.messages,
              (Messages{"test.lxs:2:8: warning: volume region \"cloud\" is not rendered: it is "
                        "left out"}));
    expect_start(error_of_world("Volume \"clout\""),
                 "test.lxs:2:8: error: unknown volume region \"clout\"; did you mean \"cloud\"?");
}

TEST(PluginNames, ATextureThatIsNotRenderedIsNotThere) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_world(
        "Texture \"b\" \"color\" \"brick\"\nMaterial \"matte\" \"texture Kd\" [\"b\"] Shape "
        "\"sphere\"",
        diagnostics);
    EXPECT_EQ(fake(contents.primitives.at(0)).kd(), Rgb(0.9f));
    EXPECT_EQ(diagnostics.messages,
              (Messages{"test.lxs:2:21: warning: color texture \"brick\" is not rendered yet: "
                        "parameters that name it keep their defaults"}));
}

TEST(PluginNames, WrongParameterTypeIsLocated) {
    EXPECT_EQ(
        error_of_text("WorldBegin\nShape \"sphere\"\n  \"string radius\" [\"big\"]\nWorldEnd"),
        "test.lxs:3:3: error: sphere: \"radius\" takes \"float radius\" [number], found a value "
        "of type string\n"
        "    \"string radius\" [\"big\"]\n"
        "    ^");
}

TEST(PluginNames, UnknownParameterWarnsWithTheNearest) {
    CollectingDiagnostics diagnostics;
    read_world("Shape \"sphere\" \"float raduis\" [1]", diagnostics);
    EXPECT_EQ(
        diagnostics.messages,
        (Messages{"test.lxs:2:16: warning: sphere: unknown parameter \"raduis\"; did you mean "
                  "\"radius\"?"}));
}

}  // namespace
}  // namespace lxs::test::plugin_name_test
