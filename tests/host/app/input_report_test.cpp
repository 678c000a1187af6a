// Protects what a user is told of a scene that is not quite LuxRender's, or not ours: where
// LuxRender goes on so does lxsrender, --strict refuses, all that is wrong is told in one run,
// kinds with their counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error_rows.h"
#include "lxsrender_process.h"

namespace lxs::test::input_report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class InputReport : public testing::Test {
  protected:
    RunResult render(const std::string& options, const std::string& world,
                     std::vector<std::string> arguments = {}) {
        folder_.write("scene.lxs", small_scene(options, world));
        arguments.insert(arguments.begin(), {"scene.lxs", "--passes", "1"});
        return run_lxsrender(folder_, arguments);
    }
    TemporaryFolder folder_;
};

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST_F(InputReport, MessagesOfAKindAreOneWithTheirCount) {
    std::string world;
    for (int i = 0; i < 40; ++i)
        world += "Shape \"plymesh\" \"string filename\" [\"part" + std::to_string(i) + ".ply\"]\n";
    const RunResult run = render("", world);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(count(run.err, "warning: no file"), 1u) << run.err;
    EXPECT_THAT(
        run.err,
        HasSubstr("warning: no file \"part0.ply\"; looked in \".\" and beside the file that "
                  "names it; the shape is skipped (40 of this kind, also \"part1.ply\", "
                  "\"part2.ply\", \"part3.ply\", \"part4.ply\", \"part5.ply\", ...)"));
    EXPECT_LT(run.err.size(), 2000u) << "no flood";
    const RunResult same = render("", "Shape \"teapot\"\nShape \"teapot\"\n");
    EXPECT_THAT(same.err, HasSubstr("; the shape is skipped (2 times)"));
}

TEST_F(InputReport, MessagesShowLinesOfLargeFilesToo) {
    const RunResult run =
        render("", "#" + std::string(std::size_t{17} << 20, '-') + "\n  Shape \"teapot\"\n");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("; the shape is skipped\n    Shape \"teapot\"\n          ^\n"));
}

TEST_F(InputReport, AllErrorsAreToldInOneRun) {
    const RunResult run = render(
        "Camera \"perspectiv\"\nVolumeIntegrator \"hovercraft\"\nRenderer \"hovercraft\"\n"
        "SurfaceIntegrator \"aips\" \"string guide\" [\"papper\"]",
        "Shapes \"sphere\"\nRotate 30 0 0 0\nMaterial \"glas\"\nLightSource \"lamp\"");
    EXPECT_EQ(run.exit_code, 3) << run.err;
    for (const char* message :
         {"unknown statement \"Shapes\"", "Rotate about an axis of length 0",
          "unknown Camera \"perspectiv\"", "unknown VolumeIntegrator \"hovercraft\"",
          "unknown Renderer \"hovercraft\"", "aips: unknown guide \"papper\""})
        EXPECT_THAT(run.err, HasSubstr(std::string("error: ") + message));
    EXPECT_THAT(run.err, HasSubstr("warning: unknown material \"glas\""));
    EXPECT_THAT(run.err, HasSubstr("warning: unknown light source \"lamp\""));
    EXPECT_THAT(run.err, HasSubstr("error: nothing is rendered: 6 errors"));
    EXPECT_FALSE(folder_.has("out.exr"));
}

TEST_F(InputReport, ErrorsOfLightsAreToldBesideOthers) {
    const RunResult run =
        render("", "Rotate 1 0 0 0\nLightSource \"infinite\" \"string mapname\" [\"no.exr\"]",
               {"--strict"});
    EXPECT_THAT(run.err, HasSubstr("error: Rotate about an axis of length 0"));
    EXPECT_THAT(run.err, HasSubstr("error: no file \"no.exr\""));
    EXPECT_THAT(run.err, HasSubstr("nothing is rendered: 2 errors"));
}

TEST_F(InputReport, EachWrongValueOfAnIntegratorOfOursIsTold) {
    const RunResult run = render(
        "SurfaceIntegrator \"aips\" \"integer maxeyedepth\" [-1] \"bool eyeseeding\" [\"yes\"]",
        "");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_THAT(run.err, HasSubstr("error: aips: \"maxeyedepth\" is out of range"));
    EXPECT_THAT(run.err, HasSubstr("error: aips: \"eyeseeding\" takes \"true\" or \"false\""));
}

TEST_F(InputReport, AWrongFilmAndAMissingEndHideNothing) {
    folder_.write("scene.lxs",
                  "Film \"flexiimage\"\nCamera \"perspectiv\"\nSurfaceIntegrator \"hovercraft\"\n"
                  "WorldBegin\n");
    const RunResult run = run_lxsrender(folder_, {"scene.lxs", "--passes", "1"});
    EXPECT_EQ(run.exit_code, 3) << run.err;
    for (const char* message :
         {"unknown Film \"flexiimage\"", "unknown Camera \"perspectiv\"",
          "unknown SurfaceIntegrator \"hovercraft\"", "the scene ends without WorldEnd"})
        EXPECT_THAT(run.err, HasSubstr(std::string("error: ") + message));
    EXPECT_THAT(run.err, Not(HasSubstr("no light"))) << "what was not read may be one";
}

/// The list of known names, the nearest first, differs from message to message.
TEST_F(InputReport, UnknownNamesAreOneKindWhateverIsNear) {
    std::string world;
    for (const char* name : {"glas", "mat", "mirorr", "zzzz", "metl"})
        world += "Material \"" + std::string(name) + "\"\n";
    const RunResult run = render("", world);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(count(run.err, "warning: unknown material"), 1u) << run.err;
    EXPECT_THAT(run.err, HasSubstr("(5 of this kind, also \"mat\", \"mirorr\", \"zzzz\", "));
}

struct Fallback {
    const char* options;
    const char* world;
    const char* message;
};

constexpr Fallback kFallbacks[] = {
    {"", "Material \"glas\"", "unknown material \"glas\""},
    {"", "NamedMaterial \"no\"", "unknown named material \"no\""},
    {"", "Texture \"t\" \"color\" \"checkerboard\"", "unknown color texture \"checkerboard\""},
    {"", "Material \"matte\" \"texture Kd\" [\"no\"]", "unknown color texture \"no\""},
    {"", "Shape \"teapot\"", "unknown shape \"teapot\""},
    {"", "Shape \"plymesh\" \"string filename\" [\"no.ply\"]", "no file \"no.ply\""},
    {"", "Shape \"sphere\" \"string radius\" [\"big\"]", "sphere: \"radius\" takes"},
    {"", "LightSource \"lamp\"", "unknown light source \"lamp\""},
    {"", "LightSource \"infinite\" \"string mapname\" [\"no.exr\"]", "no file \"no.exr\""},
    {"", "LightSource \"point\" \"string iesname\" [\"no.ies\"]", "no file \"no.ies\""},
    {"", "AreaLightSource \"area\" \"string iesname\" [\"no.ies\"]", "no file \"no.ies\""},
    {"", "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"no.png\"]",
     "no file \"no.png\""},
    {"", "Material \"metal\" \"string filename\" [\"no.nk\"]", "no file \"no.nk\""},
    {"", "Include \"no.lxo\"", "no file \"no.lxo\""},
    {"", "AttributeBegin", "AttributeBegin is not closed by AttributeEnd"},
    {"", "AttributeEnd", "AttributeEnd without AttributeBegin"},
    {"", "Material \"metal\" \"string name\" [\"mud\"]", "unknown metal \"mud\""},
    {"", "Material \"carpaint\" \"string name\" [\"pink\"]", "unknown car paint \"pink\""},
    {"", "Material \"cloth\" \"string presetname\" [\"tweed\"]", "unknown cloth \"tweed\""},
    {"", "MakeNamedMaterial \"m\" \"string type\" [\"matte\" \"glass\"]",
     "the material's type is written"},
    {"", "Camera \"perspective\"", "Camera stands before WorldBegin only"},
    {"Renderer \"luxcore\"", "", "Renderer \"luxcore\" is not rendered"},
    {"Sampler \"sobol\"", "", "unknown Sampler \"sobol\""},
    {"Accelerator \"octree\"", "", "unknown Accelerator \"octree\""},
    {"Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6] "
     "\"string filename\" [\"out\"] \"string tonemapkernel\" [\"filmic\"]",
     "", "fleximage: unknown tonemapkernel \"filmic\""},
    {"SurfaceIntegrator \"path\" \"integer maxdepth\" [-1]", "",
     "path: \"maxdepth\" is out of range"},
    {"SurfaceIntegrator \"bidirectional\"", "",
     "SurfaceIntegrator \"bidirectional\" is not rendered"},
};

/// Forked: each start of the program itself takes a good part of a second.
TEST_F(InputReport, WhereLuxRenderGoesOnIsAWarningAndStrictAnError) {
    for (const Fallback& fallback : kFallbacks) {
        SCOPED_TRACE(std::string(fallback.options) + fallback.world);
        folder_.write("scene.lxs", small_scene(fallback.options, fallback.world));
        const RunResult run = run_forked(folder_, {"scene.lxs", "--passes", "1"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        EXPECT_THAT(run.err, HasSubstr(std::string("warning: ") + fallback.message));
        const RunResult strict = run_forked(folder_, {"scene.lxs", "--passes", "1", "--strict"});
        EXPECT_EQ(strict.exit_code, 3) << strict.err;
        EXPECT_THAT(strict.err, HasSubstr(std::string("error: ") + fallback.message));
    }
}

TEST_F(InputReport, RenderersOfOtherVersionsAreTheNearest) {
    for (const std::string name : {"luxcore", "slg", "hybrid", "hybridsampler", "hybridsppm"}) {
        const RunResult run = render("Renderer \"" + name + "\" \"string config\" [\"a = b\"]", "");
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const std::string nearest = name == "hybridsppm" ? "sppm" : "sampler";
        const std::string warning = "warning: Renderer \"" + name + "\" is not rendered; \"";
        EXPECT_THAT(run.err, HasSubstr(warning + nearest + "\" is used instead"));
        EXPECT_THAT(run.err, HasSubstr(nearest == "sppm" ? "with \"sppm\"" : "with \"path\""));
    }
}

TEST_F(InputReport, IntegratorsThatAreNotOursNameAips) {
    for (const std::string name :
         {"bidirectional", "directlighting", "distributedpath", "igi", "particletracing"}) {
        const RunResult run = render("SurfaceIntegrator \"" + name + "\"", "");
        EXPECT_EQ(run.exit_code, 0) << run.err;
        EXPECT_THAT(run.err, HasSubstr("SurfaceIntegrator \"" + name +
                                       "\" is not rendered; \"path\" is used instead; \"aips\" "
                                       "(--integrator aips) shoots photons too"));
    }
}

TEST_F(InputReport, APinholeNeedsNoFocus) {
    EXPECT_EQ(render("Camera \"perspective\" \"float focaldistance\" [0]", "").exit_code, 0);
    const std::string lens =
        "Camera \"perspective\" \"float lensradius\" [0.1] \"float focaldistance\" [0]";
    EXPECT_EQ(render(lens + " \"bool autofocus\" [\"true\"]", "").exit_code, 0);
    EXPECT_EQ(render(lens, "").exit_code, 3);
}

TEST_F(InputReport, OldNamesOfFilesAreNotTakenForOthers) {
    const RunResult run = render(
        "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6] "
        "\"string filename\" [\"out\"] \"bool write_tonemapped_tga\" [\"false\"]",
        "");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("\"write_tonemapped_tga\" has no effect here"));
    EXPECT_THAT(run.err, Not(HasSubstr("did you mean")));
}

TEST_F(InputReport, SpheresAreShapesToo) {
    const RunResult run = render("", "Shape \"sphere\" \"float radius\" [0.1]");
    EXPECT_THAT(run.err, HasSubstr("scene: 2 round shapes (spheres, disks, ...), 1 light"));
    EXPECT_THAT(run.err, Not(HasSubstr("triangles")));
}

}  // namespace
}  // namespace lxs::test::input_report_test
