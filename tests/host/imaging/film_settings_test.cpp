// Protects what the Film statement means: sizes, crop window, names, halts, and the warnings about
// what has no effect.
#include "film_settings.h"

#include <gtest/gtest.h>

#include "scene_options.h"

namespace lxs::test::film_settings_test {
namespace {

struct Read {
    RecordedDiagnostics diagnostics;
    FilmSettings settings;

    explicit Read(std::vector<ParameterValue> values, const std::string& plugin = "fleximage") {
        SceneContents contents = empty_scene();
        set_option(contents, "Film", plugin, std::move(values));
        settings = read_film_settings(contents, diagnostics);
    }
};

TEST(FilmSettings, DefaultsAreLuxRenders) {
    RecordedDiagnostics diagnostics;
    const FilmSettings s = read_film_settings(empty_scene(), diagnostics);
    EXPECT_EQ(s.frame.width, 800u);
    EXPECT_EQ(s.frame.height, 600u);
    EXPECT_EQ(s.base_name, "luxout");
    EXPECT_EQ(s.halt_time_seconds, 0);
    EXPECT_EQ(s.halt_passes, 0u);
    EXPECT_EQ(s.write_interval_seconds, 60);
    EXPECT_EQ(s.display_interval_seconds, 12);
    EXPECT_EQ(s.tone_map.gamma, 2.2);
    EXPECT_EQ(s.tone_map.kernel, ToneMapSettings::Kernel::AutoLinear);
    EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST(FilmSettings, ReadsHaltsAndNames) {
    const Read read({integer("halttime", 840), integer("haltspp", 12), integer("writeinterval", 5),
                     integer("displayinterval", 3), text("filename", "cornell.Scene.00001")});
    EXPECT_EQ(read.settings.halt_time_seconds, 840);
    EXPECT_EQ(read.settings.halt_passes, 12u);
    EXPECT_EQ(read.settings.write_interval_seconds, 5);
    EXPECT_EQ(read.settings.display_interval_seconds, 3);
    EXPECT_EQ(Read({integer("displayinterval", -1)}).settings.display_interval_seconds, 0);
    EXPECT_EQ(read.settings.base_name, "cornell.Scene.00001");
    EXPECT_EQ(Read({text("filename", "a/out.png")}).settings.base_name, "a/out");
    EXPECT_EQ(Read({integer("haltspp", -1)}).settings.halt_passes, 0u);
    EXPECT_NEAR(Read({real("haltthreshold", 0.05)}).settings.halt_error, 0.05, 1e-7);
    EXPECT_EQ(Read({real("haltthreshold", -1)}).settings.halt_error, 0);
}

TEST(FilmSettings, CropWindowSelectsPixels) {
    const Read read({integer("xresolution", 100), integer("yresolution", 50),
                     numbers("float", "cropwindow", {0.1, 0.35, 0.5, 1})});
    EXPECT_EQ(read.settings.frame.x, 10u);
    EXPECT_EQ(read.settings.frame.width, 25u);
    EXPECT_EQ(read.settings.frame.y, 25u);
    EXPECT_EQ(read.settings.frame.height, 25u);
    EXPECT_TRUE(read.diagnostics.warnings.empty());
}

TEST(FilmSettings, ReversedCropWindowIsSwappedWithAWarning) {
    const Read read({integer("xresolution", 100), integer("yresolution", 50),
                     numbers("float", "cropwindow", {0.35, 0.1, 0, 1})});
    EXPECT_EQ(read.settings.frame.x, 10u);
    EXPECT_EQ(read.settings.frame.width, 25u);
    EXPECT_EQ(read.diagnostics.warnings,
              std::vector<std::string>{"scene.lxs:2:5: warning: cropwindow has its bounds 0.35 and "
                                       "0.1 reversed; they are swapped"});
}

TEST(FilmSettings, AnEmptyCropWindowKeepsOnePixel) {
    const Read read({integer("xresolution", 10), numbers("float", "cropwindow", {1, 1, 0.5, 0.5})});
    EXPECT_EQ(read.settings.frame.x, 9u);
    EXPECT_EQ(read.settings.frame.width, 1u);
    EXPECT_EQ(read.settings.frame.height, 1u);
}

TEST(FilmSettings, FlagsWarnOnlyWhenTheyAskForSomethingElse) {
    const Read quiet({flag("write_exr", false), flag("write_exr_halftype", false),
                      flag("write_exr_applyimaging", false), flag("write_tga", false),
                      text("write_exr_channels", "RGB"), integer("outlierrejection_k", 0),
                      numbers("float", "colorspace_red", {0.63, 0.34}),
                      integer("displayinterval", 12), integer("tilecount", 0)});
    EXPECT_TRUE(quiet.diagnostics.warnings.empty());
    EXPECT_TRUE(quiet.diagnostics.unknown.empty());

    const Read loud({flag("write_exr_halftype", true), flag("write_exr_applyimaging", true)});
    EXPECT_EQ(loud.diagnostics.warnings,
              (std::vector<std::string>{
                  "scene.lxs:2:5: warning: \"write_exr_halftype\" has no effect: the EXR always "
                  "holds 32-bit floats",
                  "scene.lxs:2:5: warning: \"write_exr_applyimaging\" has no effect: the EXR "
                  "always holds raw linear radiance"}));
}

TEST(FilmSettings, WhatIsWrittenAnywayIsWarnedOfWhereItIsRefused) {
    EXPECT_TRUE(Read({flag("write_png", true), flag("write_png_gamutclamp", true)})
                    .diagnostics.warnings.empty());
    EXPECT_EQ(Read({flag("write_png", false)}).diagnostics.warnings,
              std::vector<std::string>{"scene.lxs:2:5: warning: \"write_png\" has no effect: the "
                                       "PNG is always written"});
    EXPECT_EQ(Read({flag("write_png_gamutclamp", false)}).diagnostics.warnings.size(), 1u);
}

TEST(FilmSettings, MisspeltParameterIsReported) {
    const Read read({text("tonemappkernel", "linear")});
    EXPECT_EQ(read.diagnostics.unknown,
              std::vector<std::string>{"scene.lxs:2:5: warning: fleximage: unknown parameter "
                                       "\"tonemappkernel\"; did you mean \"tonemapkernel\"?"});
}

TEST(FilmSettings, MultiImageIsTakenAsFlexImage) {
    const Read read({integer("xresolution", 60), text("hdr_filename", "old.exr"),
                     integer("hdr_writeinterval", 7), text("tonemapper", "reinhard")},
                    "multiimage");
    EXPECT_EQ(read.settings.frame.width, 60u);
    EXPECT_EQ(read.settings.base_name, "old");
    EXPECT_EQ(read.settings.write_interval_seconds, 7);
    EXPECT_EQ(read.settings.tone_map.kernel, ToneMapSettings::Kernel::Reinhard);
    EXPECT_EQ(read.diagnostics.warnings,
              std::vector<std::string>{
                  "scene.lxs:1:6: warning: Film \"multiimage\" is treated as \"fleximage\""});
}

TEST(FilmSettings, OlderNamesGiveWayToTodays) {
    const Read read({text("filename", "new"), text("hdr_filename", "old"),
                     integer("writeinterval", 5), integer("hdr_writeinterval", 7),
                     text("tonemapkernel", "linear"), text("tonemapper", "reinhard")});
    EXPECT_EQ(read.settings.base_name, "new");
    EXPECT_EQ(read.settings.write_interval_seconds, 5);
    EXPECT_EQ(read.settings.tone_map.kernel, ToneMapSettings::Kernel::Linear);
    const std::string start = "scene.lxs:2:5: warning: fleximage: ";
    EXPECT_EQ(read.diagnostics.warnings,
              (std::vector<std::string>{
                  start + "\"filename\" is used in place of \"hdr_filename\"",
                  start + "\"writeinterval\" is used in place of \"hdr_writeinterval\"",
                  start + "\"tonemapkernel\" is used in place of \"tonemapper\""}));
}

}  // namespace
}  // namespace lxs::test::film_settings_test
