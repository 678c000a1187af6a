// Protects the messages and the exit code of bad scenes: each says where, what was found and what
// was expected, and no image is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxsrender_process.h"

namespace lxs::test::bad_input_test {
namespace {

using testing::HasSubstr;

class BadInputTest : public testing::Test {
  protected:
    /// Renders "scene.lxs" of the folder; it must fail as bad input and write nothing.
    std::string error_of_scene(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"scene.lxs", "--passes", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult result = run_lxsrender(folder_, arguments);
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_FALSE(folder_.has("out.exr"));
        return result.err;
    }
    std::string error_of(const std::string& scene) {
        folder_.write("scene.lxs", scene);
        return error_of_scene();
    }
    /// For what LuxRender goes on from: input_report_test.cpp has what is said without --strict.
    std::string strict_error_of(const std::string& scene) {
        folder_.write("scene.lxs", scene);
        return error_of_scene({"--strict"});
    }
    TemporaryFolder folder_;
};

constexpr const char* kTriangle = "\"integer indices\" [0 1 2] \"point P\" [0 0 0  1 0 0  0 1 0]";

TEST_F(BadInputTest, MissingFile) {
    const std::string error = error_of_scene();
    EXPECT_THAT(error, HasSubstr("scene.lxs"));
    EXPECT_THAT(error, HasSubstr("No such file or directory"));
}

TEST_F(BadInputTest, SyntaxErrorInsideAnIncludedFileShowsTheChain) {
    folder_.write("part.lxo", "Shape \"sphere\" \"float radius\" [1\n");
    const std::string error = error_of(small_scene("", "Include \"part.lxo\""));
    EXPECT_THAT(error, HasSubstr("part.lxo:"));
    EXPECT_THAT(error, HasSubstr("error:"));
    EXPECT_THAT(error, HasSubstr("included from "));
    EXPECT_THAT(error, HasSubstr("scene.lxs:"));
}

TEST_F(BadInputTest, UnknownStatement) {
    const std::string error = error_of(small_scene("", "Shapes \"sphere\""));
    EXPECT_THAT(error, HasSubstr("scene.lxs:9:1: error: unknown statement \"Shapes\"; did you mean "
                                 "Shape?\n  Shapes \"sphere\"\n  ^"));
}

TEST_F(BadInputTest, WrongParameterType) {
    const std::string error =
        strict_error_of(small_scene("SurfaceIntegrator \"path\" \"string maxdepth\" [\"deep\"]"));
    EXPECT_THAT(error, HasSubstr("error: path: \"maxdepth\" takes "));
    EXPECT_THAT(error, HasSubstr("found a value of type string"));
    EXPECT_THAT(error, HasSubstr("^"));
}

TEST_F(BadInputTest, MeshIndexOutOfRange) {
    const std::string error = strict_error_of(small_scene(
        "", "Shape \"trianglemesh\" \"integer indices\" [0 1 7] \"point P\" [0 0 0 1 0 0 0 1 0]"));
    EXPECT_THAT(error, HasSubstr("scene.lxs:9:"));
    EXPECT_THAT(error, HasSubstr("7"));
    EXPECT_THAT(error, HasSubstr("error:"));
}

TEST_F(BadInputTest, MeshVertexThatIsNoPlace) {
    for (const std::string number : {"nan", "-inf", "1e99"}) {
        folder_.write("scene.lxs", small_scene("",
                                               "Shape \"trianglemesh\" \"integer indices\" [0 1 2] "
                                               "\"point P\" [0 0 " +
                                                   number + " 1 0 0 0 1 0]"));
        const RunResult result = run_lxsrender(folder_, {"scene.lxs", "--passes", "1"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.err, HasSubstr("scene.lxs:9:"));
        EXPECT_THAT(result.err, HasSubstr("warning: vertex 0 of \"P\" is not finite: (0, 0, "));
        EXPECT_THAT(result.err, HasSubstr("; the shape is skipped"));
    }
}

TEST_F(BadInputTest, AreaLightOfZeroArea) {
    folder_.write("scene.lxs", small_scene("",
                                           "AreaLightSource \"area\" \"color L\" [1 1 1]\n"
                                           "Shape \"trianglemesh\" \"integer indices\" [0 1 2] "
                                           "\"point P\" [0 0 0 1 0 0 2 0 0]"));
    const RunResult result = run_lxsrender(folder_, {"scene.lxs", "--passes", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err,
                HasSubstr("scene.lxs:10:7: warning: no triangle of the mesh has an area; "
                          "the shape is skipped"));
}

TEST_F(BadInputTest, NoLightAtAll) {
    const std::string error =
        error_of("WorldBegin\nShape \"trianglemesh\" " + std::string(kTriangle) + "\nWorldEnd\n");
    EXPECT_THAT(error, HasSubstr("scene.lxs:3:1: error: the scene has no light: expected a "
                                 "LightSource, or a Shape after an AreaLightSource"));
}

TEST_F(BadInputTest, NoCameraWarnsAndUsesLuxRendersDefault) {
    folder_.write("scene.lxs",
                  "Film \"fleximage\" \"integer xresolution\" [4] \"integer yresolution\" [4]\n"
                  "WorldBegin\nLightSource \"point\"\nWorldEnd\n");
    const RunResult result = run_lxsrender(folder_, {"scene.lxs", "--passes", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("scene.lxs:4:1: warning: the scene has no Camera statement; "
                                      "using LuxRender's default: a perspective camera with fov 90 "
                                      "at the origin, looking along +z"));
    EXPECT_EQ(result.err.find("Camera"), result.err.rfind("Camera")) << "said once";
}

TEST_F(BadInputTest, FilmResolutions) {
    const auto film = [](const std::string& x, const std::string& y) {
        return "Film \"fleximage\" \"integer xresolution\" [" + x + "] \"integer yresolution\" [" +
               y + "]\nWorldBegin\nLightSource \"point\"\nWorldEnd\n";
    };
    const std::string zero = error_of(film("0", "10"));
    EXPECT_THAT(zero, HasSubstr("scene.lxs:1:"));
    EXPECT_THAT(zero, HasSubstr("error: xresolution is 0, but must be from 1 to "));
    const std::string huge = error_of(film("1000000", "1000000"));
    EXPECT_THAT(huge, HasSubstr("scene.lxs:1:"));
    EXPECT_THAT(huge, HasSubstr("error:"));
    EXPECT_THAT(huge, HasSubstr("1000000"));
}

TEST_F(BadInputTest, IntegratorThatIsNoPlugin) {
    const std::string error = error_of(small_scene("SurfaceIntegrator \"whitted\""));
    EXPECT_THAT(error, HasSubstr("scene.lxs:5:"));
    EXPECT_THAT(error, HasSubstr("error: unknown SurfaceIntegrator \"whitted\""));
    EXPECT_THAT(error, HasSubstr("aips, exphotonmap, path, ppm, sppm"));
}

// Not an error: a scene of LuxRender's shows its picture, by another integrator.
TEST_F(BadInputTest, IntegratorOfLuxRenderThatIsNoPluginIsRenderedByPath) {
    folder_.write("scene.lxs", small_scene("SurfaceIntegrator \"bidirectional\""));
    const RunResult result = run_lxsrender(folder_, {"scene.lxs", "--passes", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err + result.out,
                HasSubstr("scene.lxs:5:19: warning: SurfaceIntegrator \"bidirectional\" is not "
                          "rendered; \"path\" is used instead"));
}

TEST_F(BadInputTest, UnknownRendererVolumeIntegratorAndAccelerator) {
    const auto scene = [](const std::string& kind) {
        return small_scene(kind + " \"hovercraft\"");
    };
    for (const std::string kind : {"Renderer", "VolumeIntegrator"})
        EXPECT_THAT(error_of(scene(kind)), HasSubstr("unknown " + kind + " \"hovercraft\""));
    EXPECT_THAT(strict_error_of(scene("Accelerator")),
                HasSubstr("unknown Accelerator \"hovercraft\""));
}

TEST_F(BadInputTest, ParameterOutOfRange) {
    const std::string error =
        strict_error_of(small_scene("SurfaceIntegrator \"path\" \"float rrcontinueprob\" [7]"));
    EXPECT_THAT(error, HasSubstr("\"rrcontinueprob\" is out of range: 7"));
}

}  // namespace
}  // namespace lxs::test::bad_input_test
