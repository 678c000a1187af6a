// Pins the messages about bad option statements.
#include <gtest/gtest.h>

#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test::option_errors_test {
namespace {

std::string film_error(std::vector<ParameterValue> values) {
    SceneContents contents = empty_scene();
    set_option(contents, "Film", "fleximage", std::move(values));
    RecordedDiagnostics diagnostics;
    return input_error([&] { make_film(contents, diagnostics); });
}

struct CameraResult {
    std::string error;
    RecordedDiagnostics diagnostics;
};

CameraResult camera(const std::string& plugin, std::vector<ParameterValue> values,
                    const Matrix& transform = Matrix()) {
    SceneContents contents = scene_of_size(8, 8);
    if (!plugin.empty()) {
        set_option(contents, "Camera", plugin, std::move(values)).transform = transform;
    }
    CameraResult result;
    const auto film = make_film(contents, result.diagnostics);
    result.error = input_error([&] { make_camera(contents, *film, result.diagnostics); });
    return result;
}

TEST(FilmErrors, ResolutionOutOfRange) {
    EXPECT_EQ(film_error({integer("xresolution", 0)}),
              "scene.lxs:2:5: error: xresolution is 0, but must be from 1 to 134217728");
    EXPECT_EQ(film_error({integer("yresolution", -5)}),
              "scene.lxs:2:5: error: yresolution is -5, but must be from 1 to 134217728");
    EXPECT_EQ(film_error({integer("xresolution", 1e6), integer("yresolution", 1e6)}),
              "scene.lxs:2:5: error: 1000000 x 1000000 pixels are 1000000000000, more than the "
              "limit of 134217728");
}

TEST(FilmErrors, CropWindowNeedsFourNumbers) {
    EXPECT_EQ(film_error({numbers("float", "cropwindow", {0, 1, 0})}),
              "scene.lxs:2:5: error: cropwindow takes 4 numbers, found 3");
}

TEST(FilmErrors, EmptyFileName) {
    EXPECT_EQ(film_error({text("filename", "")}), "scene.lxs:2:5: error: filename is empty");
}

TEST(OptionErrors, UnknownPluginsListTheKnownOnes) {
    RecordedDiagnostics diagnostics;
    SceneContents contents = empty_scene();
    set_option(contents, "Film", "flexiimage", {});
    EXPECT_EQ(input_error([&] { make_film(contents, diagnostics); }),
              "scene.lxs:1:6: error: unknown Film \"flexiimage\"; did you mean \"fleximage\"? "
              "Known: fleximage, multiimage");
    contents = empty_scene();
    set_option(contents, "PixelFilter", "zzz", {});
    EXPECT_EQ(input_error([&] { make_film(contents, diagnostics); }),
              "scene.lxs:1:6: error: unknown PixelFilter \"zzz\"; known: blackmanharris, box, "
              "catmullrom, gaussian, mitchell, sinc, triangle");
    contents = empty_scene();
    set_option(contents, "Sampler", "zzz", {});
    EXPECT_EQ(input_error([&] { make_sampler(contents, 0, diagnostics); }),
              "scene.lxs:1:6: error: unknown Sampler \"zzz\"; known: erpt, lowdiscrepancy, "
              "metropolis, random");
    EXPECT_EQ(camera("realistic", {}).error,
              "scene.lxs:1:6: error: unknown Camera \"realistic\"; known: environment, "
              "orthographic, perspective");
}

TEST(CameraErrors, ImpossibleParameters) {
    EXPECT_EQ(camera("perspective", {real("fov", 180)}).error,
              "scene.lxs:2:5: error: fov is 180, but must lie between 0 and 180 degrees");
    EXPECT_EQ(camera("perspective", {numbers("float", "screenwindow", {1, 1, 0, 1})}).error,
              "scene.lxs:2:5: error: screenwindow is empty");
    EXPECT_EQ(camera("perspective", {numbers("float", "screenwindow", {1, 2})}).error,
              "scene.lxs:2:5: error: screenwindow takes 4 numbers, found 2");
    EXPECT_EQ(camera("perspective", {real("hither", 2), real("yon", 1)}).error,
              "scene.lxs:2:5: error: yon is 1, but must be beyond hither, 2");
    EXPECT_EQ(camera("orthographic", {real("focaldistance", 0), real("lensradius", 0.1)}).error,
              "scene.lxs:2:5: error: focaldistance is 0, but must be positive");
    Matrix flat;
    flat.setScale(Imath::V3d(1, 1, 0));
    EXPECT_EQ(camera("perspective", {}, flat).error,
              "scene.lxs:1:6: error: the camera's transform is singular: it has no inverse");
}

TEST(CameraErrors, WarningsSayWhatHasNoEffect) {
    using Lines = std::vector<std::string>;
    EXPECT_EQ(camera("", {}).diagnostics.warnings,
              Lines{"scene.lxs:9:1: warning: the scene has no Camera statement; using LuxRender's "
                    "default: a perspective camera with fov 90 at the origin, looking along +z"});
    EXPECT_EQ(camera("perspective", {text("distribution", "gaussian"), real("lensradius", 0.1)})
                  .diagnostics.warnings,
              Lines{"scene.lxs:2:5: warning: \"distribution\" has no effect: the aperture is "
                    "uniform"});
    EXPECT_TRUE(
        camera("perspective", {text("distribution", "gaussian")}).diagnostics.warnings.empty())
        << "a pinhole has no aperture";
    EXPECT_EQ(camera("perspective", {real("shutteropen", 1), real("shutterclose", 0)})
                  .diagnostics.warnings,
              Lines{"scene.lxs:2:5: warning: the shutter closes before it opens; the times are "
                    "swapped"});
}

TEST(SamplerErrors, MarkovChainSamplersAreNamedOnce) {
    SceneContents contents = empty_scene();
    set_option(contents, "Sampler", "metropolis",
               {real("largemutationprob", 0.4), flag("noiseaware", false),
                integer("maxconsecrejects", 512), flag("usecooldown", true)});
    RecordedDiagnostics diagnostics;
    make_sampler(contents, 0, diagnostics);
    EXPECT_EQ(diagnostics.warnings,
              std::vector<std::string>{"scene.lxs:1:6: warning: Sampler \"metropolis\" has no "
                                       "effect: every pixel gets the same number of samples"});
    EXPECT_TRUE(diagnostics.unknown.empty());
}

TEST(SamplerErrors, WhatWouldMatterIsSaidToHaveNoEffect) {
    SceneContents contents = empty_scene();
    set_option(contents, "Sampler", "lowdiscrepancy",
               {text("pixelsampler", "hilbert"), flag("noiseaware", true)});
    RecordedDiagnostics diagnostics;
    make_sampler(contents, 0, diagnostics);
    EXPECT_EQ(diagnostics.warnings,
              (std::vector<std::string>{"scene.lxs:2:5: warning: \"pixelsampler\" has no effect: a "
                                        "pass covers the whole image",
                                        "scene.lxs:2:5: warning: \"noiseaware\" has no effect: all "
                                        "pixels get as many samples"}));
    diagnostics.warnings.clear();
    set_option(contents, "Sampler", "random",
               {text("pixelsampler", "linear"), flag("noiseaware", false)});
    make_sampler(contents, 0, diagnostics);
    EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST(SamplerErrors, MetropolisSettingsReachIntegratorsThatRunChains) {
    SceneContents contents = empty_scene();
    set_option(contents, "Sampler", "metropolis",
               {real("largemutationprob", 0.3), integer("maxconsecrejects", 64),
                real("mutationrange", 12)});
    RecordedDiagnostics diagnostics;
    const auto sampler = make_sampler(contents, 0, diagnostics, true);
    ASSERT_NE(sampler->metropolis(), nullptr);
    EXPECT_FLOAT_EQ(static_cast<float>(sampler->metropolis()->large_probability), 0.3f);
    EXPECT_EQ(sampler->metropolis()->max_consecutive_rejects, 64u);
    EXPECT_EQ(sampler->metropolis()->film_range, 12);
    EXPECT_TRUE(diagnostics.warnings.empty() && diagnostics.unknown.empty());
    EXPECT_EQ(make_sampler(contents, 0, diagnostics)->metropolis(), nullptr);
    EXPECT_EQ(make_sampler(empty_scene(), 0, diagnostics, true)->metropolis(), nullptr);
}

TEST(SamplerErrors, MetropolisParametersAreChecked) {
    SceneContents contents = empty_scene();
    RecordedDiagnostics diagnostics;
    set_option(contents, "Sampler", "metropolis",
               {flag("usevariance", true), flag("usecooldown", true), flag("noiseaware", true)});
    make_sampler(contents, 0, diagnostics, true);
    EXPECT_EQ(diagnostics.warnings,
              (std::vector<std::string>{"scene.lxs:2:5: warning: metropolis: \"usevariance\", "
                                        "\"usecooldown\", \"noiseaware\" have no effect here"}));
    set_option(contents, "Sampler", "metropolis", {real("largemutationprob", 1.5)});
    EXPECT_EQ(input_error([&] { make_sampler(contents, 0, diagnostics, true); }),
              "scene.lxs:2:5: error: metropolis: \"largemutationprob\" is out of range: 1.5 is not "
              "between 0 and 1");
}

}  // namespace
}  // namespace lxs::test::option_errors_test
