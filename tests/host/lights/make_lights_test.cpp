// Statements become lights: names, declarations, messages, groups and media.
#include <gtest/gtest.h>

#include <algorithm>

#include "light_cases.h"
#include "temporary_folder.h"

namespace lxs::test::make_lights_test {
namespace {

std::string error_of(const std::string& plugin, const std::vector<ParameterValue>& values,
                     const Matrix& to_world = Matrix()) {
    RecordedDiagnostics diagnostics;
    try {
        make(plugin, values, diagnostics, to_world);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(MakeLights, EveryPluginIsRenderedFromItsDefaults) {
    for (const LightPlugin& plugin : light_plugins()) {
        RecordedDiagnostics diagnostics;
        const Lights lights = make(plugin.name, {}, diagnostics);
        EXPECT_EQ(lights.size(), contains(plugin.name, "sunsky") ? 2u : 1u) << plugin.name;
    }
}

TEST(MakeLights, UnknownNameListsTheKnownOnes) {
    EXPECT_TRUE(contains(error_of("lamp", {}),
                         "unknown light source \"lamp\"; known: distant, goniometric, infinite, "
                         "infinitesample, point, projection, sky, sky2, spot, sun, sunsky, "
                         "sunsky2"));
    EXPECT_TRUE(contains(error_of("piont", {}), "did you mean \"point\"? Known: point, distant"));
}

TEST(MakeLights, GoniometricAndProjectionStandWithoutAnImage) {
    RecordedDiagnostics diagnostics;
    const Lights lights = make("goniometric", {numbers("color", "I", {2, 2, 2})}, diagnostics);
    EXPECT_NEAR(lights[0]->power(), 8 * 3.14159265, 1e-3);
    // L lumens on the screen, of any angle.
    const Lights square =
        make("projection", {numbers("color", "I", {2, 2, 2}), numbers("float", "fov", {90})},
             diagnostics);
    EXPECT_NEAR(square[0]->power(), 2, 1e-3);
    EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST(MakeLights, DirectionsMustExist) {
    EXPECT_TRUE(contains(error_of("spot", {numbers("point", "from", {0, 0, 1})}),
                         "\"from\" gives the light no direction"));
    EXPECT_TRUE(contains(error_of("sun", {numbers("vector", "sundir", {0, 0, 0})}),
                         "\"sundir\" gives the light no direction"));
    EXPECT_TRUE(
        contains(error_of("sky", {}, scaling(1, 0, 1)), "the light's transform is singular"));
    EXPECT_TRUE(contains(error_of("spot", {numbers("float", "coneangle", {0})}),
                         "a spot light needs a cone angle above 0"));
}

/// Goes on where LuxRender does.
class LenientDiagnostics final : public RecordedDiagnostics {
  public:
    void fallback(const SourceLocation&, const std::string& message,
                  const std::string& instead) override {
        warnings.push_back(message + "; " + instead);
    }
};

// LuxRender's lights shine without an image or a photometric file that it can't read.
TEST(MakeLights, ADamagedFileIsToldOnceAndLeftOut) {
    const files::TemporaryFolder folder;
    folder.write("damaged.exr", "no image");
    folder.write("damaged.ies", "no file of IES");
    for (const std::string plugin : {"infinite", "point", "projection", "goniometric"}) {
        SCOPED_TRACE(plugin);
        std::vector<ParameterValue> values{text("mapname", folder / "damaged.exr"),
                                           numbers("float", "unheardof", {1})};
        if (plugin == "point") values[0] = text("iesname", folder / "damaged.ies");
        for (std::uint32_t i = 0; i < values.size(); ++i)
            values[i].where = {nullptr, 2 + i, 1};
        LenientDiagnostics diagnostics;
        EXPECT_EQ(make(plugin, values, diagnostics).size(), 1u);
        ASSERT_EQ(diagnostics.warnings.size(), 2u);
        EXPECT_TRUE(contains(diagnostics.warnings[0], "unheardof"));
        EXPECT_TRUE(contains(diagnostics.warnings[1], "; the light shines without it"));
    }
}

TEST(MakeLights, AFileIsLookedForOnce) {
    LightDescription description;
    description.parameters = {"infinite", {}, {text("mapname", "no.exr")}};
    int asked = 0;
    LenientDiagnostics diagnostics;
    const auto resolve = [&](const std::string& name, const SourceLocation& where) {
        ++asked;
        diagnostics.warning(where, "of other letter case");
        return name;
    };
    EXPECT_EQ(make_lights(description, scene_sphere(), resolve, diagnostics).size(), 1u);
    EXPECT_EQ(asked, 1);
}

TEST(MakeLights, GroupAndMediaGoWithTheLight) {
    LightDescription description;
    description.parameters.plugin = "point";
    description.group = 3;
    RecordedDiagnostics diagnostics;
    const Lights lights = make_lights(description, scene_sphere(), {}, diagnostics);
    EXPECT_EQ(lights[0]->group(), 3u);
    EmissionSample s;
    ASSERT_TRUE(lights[0]->sample_emission({0.5f, 0.5f, 0.5f, 0.5f}, s));
    EXPECT_EQ(s.ray.media, EnteredMedia());
    lights[0]->set_media(EnteredMedia().entered(2));
    ASSERT_TRUE(lights[0]->sample_emission({0.5f, 0.5f, 0.5f, 0.5f}, s));
    EXPECT_EQ(s.ray.media, EnteredMedia().entered(2));
}

TEST(MakeLights, ParametersOfRealScenesAreKnown) {
    RecordedDiagnostics diagnostics;
    make("sunsky",
         {numbers("float", "gain", {1}), numbers("float", "importance", {1}),
          numbers("float", "turbidity", {2.2}), numbers("integer", "nsamples", {4}),
          numbers("vector", "sundir", {-0.3, -0.5, 0.7})},
         diagnostics);
    ASSERT_EQ(diagnostics.warnings.size(), 1u);
    EXPECT_TRUE(contains(diagnostics.warnings[0], "have no effect here"));
}

// LuxRender's area lights have 100 W at 17 lm/W unless a scene says otherwise.
TEST(AreaLightParameters, PowerIsDeclaredWithLuxRendersDefault) {
    const auto declared = area_light_parameters();
    const auto default_of = [&](std::string_view name) {
        const auto found = std::find_if(declared.begin(), declared.end(),
                                        [&](const auto& p) { return p.name == name; });
        return found == declared.end() ? std::string_view() : found->default_text;
    };
    EXPECT_EQ(default_of("power"), "100");
    EXPECT_EQ(default_of("efficacy"), "17");
    EXPECT_EQ(default_of("L"), "1 1 1");
}

}  // namespace
}  // namespace lxs::test::make_lights_test
