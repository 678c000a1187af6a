// Statements as a whole: unknown ones, wrong places, wrong arguments, options.
#include <gtest/gtest.h>

#include "scene_fakes.h"

namespace lxs::test::statement_test {
namespace {

TEST(Statement, UnknownNameNamesTheNearest) {
    EXPECT_EQ(error_of_text("WorldBegin\n  Shpae \"sphere\"\n"),
              "test.lxs:2:3: error: unknown statement \"Shpae\"; did you mean Shape?\n"
              "  "
              "  Shpae \"sphere\"\n"
              "    ^");
    EXPECT_EQ(error_of_world("Quux 1"), "test.lxs:2:1: error: unknown statement \"Quux\"");
}

TEST(Statement, StandsInItsBlock) {
    EXPECT_EQ(first_line(error_of_text("Shape \"sphere\"")),
              "test.lxs:1:1: error: Shape stands after WorldBegin only");
    EXPECT_EQ(error_of_world("Film \"fleximage\""),
              "test.lxs:2:1: error: Film stands before WorldBegin only");
    EXPECT_EQ(error_of_world("WorldBegin"),
              "test.lxs:2:1: error: WorldBegin stands before WorldBegin only");
}

TEST(Statement, SceneMustEnd) {
    EXPECT_EQ(error_of_text("WorldBegin\nShape \"sphere\"\n"),
              "test.lxs:2:1: error: the scene ends without WorldEnd\n"
              "  Shape \"sphere\"\n"
              "  ^");
    EXPECT_EQ(first_line(error_of_text("Film \"fleximage\"")),
              "test.lxs:1:1: error: the scene ends without WorldBegin");
    EXPECT_EQ(error_of_text(""), "error: the scene ends without WorldBegin");
}

TEST(Statement, NothingIsReadAfterWorldEnd) {
    CollectingDiagnostics diagnostics;
    read_text("WorldBegin WorldEnd\nNonsense\n", diagnostics);
    EXPECT_EQ(
        diagnostics.messages,
        (std::vector<std::string>{"test.lxs:2:1: warning: what follows WorldEnd is not read"}));
}

TEST(Statement, ChecksItsArguments) {
    EXPECT_EQ(error_of_world("Translate 1 2"),
              "test.lxs:2:1: error: Translate takes 3 numbers, found 2");
    EXPECT_EQ(error_of_world("Translate"),
              "test.lxs:2:1: error: Translate takes 3 numbers, found 0");
    EXPECT_EQ(error_of_world("Scale \"1\" 2 3"),
              "test.lxs:2:1: error: Scale takes 3 numbers, found other arguments");
    EXPECT_EQ(error_of_world("Transform [1 2 3]"),
              "test.lxs:2:1: error: Transform takes 16 numbers, found 3");
    EXPECT_EQ(error_of_world("Shape"), "test.lxs:2:1: error: Shape takes a name in quotes");
    EXPECT_EQ(error_of_world("Shape 5"),
              "test.lxs:2:7: error: Shape takes a name in quotes here, found a number");
    EXPECT_EQ(error_of_world("Texture \"a\" \"float\""),
              "test.lxs:2:1: error: Texture takes 3 names in quotes");
    EXPECT_EQ(error_of_world("AttributeBegin 1"),
              "test.lxs:2:16: error: AttributeBegin takes no more, found a number");
    EXPECT_EQ(error_of_world("NamedMaterial \"a\" \"b\""),
              "test.lxs:2:19: error: NamedMaterial takes no more, found a string");
}

TEST(Statement, OptionsKeepTheirTransform) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "Renderer \"sampler\" Translate 1 2 3 Camera \"perspective\" \"float fov\" [40] "
        "Identity WorldBegin WorldEnd",
        diagnostics);
    EXPECT_EQ(contents.options.at("Camera").transform.translation(), Imath::V3d(1, 2, 3));
    EXPECT_EQ(contents.options.at("Camera").parameters.plugin, "perspective");
    EXPECT_EQ(contents.options.at("Renderer").parameters.plugin, "sampler");
    EXPECT_EQ(contents.options.count("Film"), 0u);
}

TEST(Statement, LastOfTwoOptionsCounts) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents =
        read_text("Sampler \"random\"\nSampler \"metropolis\"\nWorldBegin WorldEnd", diagnostics);
    EXPECT_EQ(contents.options.at("Sampler").parameters.plugin, "metropolis");
    EXPECT_EQ(diagnostics.messages,
              (std::vector<std::string>{
                  "test.lxs:2:1: warning: Sampler is given twice: the last one counts"}));
}

/// At each place; lxsrender tells those of a kind once (tests/host/app/input_report_test.cpp).
TEST(Statement, WarnsOfWhatIsNotRendered) {
    CollectingDiagnostics diagnostics;
    read_world(
        "PortalShape \"sphere\"\nPortalInstance \"a\"\nVolume \"cloud\"\n"
        "VolumeRegion \"cloud\"\nSearchPath \"x\"",
        diagnostics);
    EXPECT_EQ(diagnostics.messages,
              (std::vector<std::string>{
                  "test.lxs:2:1: warning: portals are not used: they only guide sampling",
                  "test.lxs:3:1: warning: portals are not used: they only guide sampling",
                  "test.lxs:4:8: warning: volume region \"cloud\" is not rendered: it is left out",
                  "test.lxs:5:14: warning: volume region \"cloud\" is not rendered: it is left out",
                  "test.lxs:6:1: warning: SearchPath has no effect"}));
}

}  // namespace
}  // namespace lxs::test::statement_test
