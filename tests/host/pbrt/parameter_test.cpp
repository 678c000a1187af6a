// Colours of parameters, colour spaces, glasses and metals by name.
#include <gtest/gtest.h>

#include "colour_space.h"
#include "lxs/language/statement_executor.h"
#include "scene_fakes.h"
#include "spectra.h"
#include "temporary_folder.h"

namespace lxs::test::pbrt_parameter_test {
namespace {

using pbrt::ColourOf;

struct Reader {
    CollectingDiagnostics diagnostics;
    Registry registry;
    StatementExecutor executor;
    pbrt::SpectrumReader spectra{executor};

    explicit Reader(const std::string& folder = ".") : executor(folder, registry, diagnostics) {}

    Rgb colour(ParameterValue value, ColourOf of, const char* space = "srgb") {
        ParameterSet set;
        value.name = "c";
        set.values.push_back(std::move(value));
        const pbrt::Parameters parameters(std::move(set), {}, *pbrt::colour_space(space),
                                          diagnostics);
        return spectra.colour(parameters, "c", of, Rgb(0.0f));
    }
    Rgb colour(const char* type, std::vector<double> numbers, ColourOf of,
               const char* space = "srgb") {
        ParameterValue value;
        value.type = type;
        value.values = std::move(numbers);
        return colour(std::move(value), of, space);
    }
    Rgb named(const std::string& name, ColourOf of) {
        ParameterValue value;
        value.type = "spectrum";
        value.values = std::vector<std::string>{name};
        return colour(std::move(value), of);
    }
};

void expect_near(const Rgb& a, const Rgb& b, float tolerance) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], tolerance);
}

TEST(PbrtColours, SrgbIsAsWritten) {
    Reader reader;
    expect_near(reader.colour("rgb", {0.1, 0.2, 0.3}, ColourOf::Light), Rgb(0.1f, 0.2f, 0.3f), 0);
    expect_near(reader.colour("rgb", {0.1, 0.2, 0.3}, ColourOf::Surface), Rgb(0.1f, 0.2f, 0.3f), 0);
    expect_near(reader.colour("float", {0.4}, ColourOf::Surface), Rgb(0.4f), 0);
    EXPECT_THROW(reader.colour("rgb", {0.1, 0.2}, ColourOf::Light), InputError);
    EXPECT_THROW(reader.colour("rgb", {0.1, -0.2, 1}, ColourOf::Light), InputError);
    EXPECT_THROW(reader.colour("blackbody", {0}, ColourOf::Light), InputError);
}

TEST(PbrtColours, OtherSpacesKeepWhite) {
    Reader reader;
    for (const char* space : {"dci-p3", "rec2020", "aces2065-1"}) {
        SCOPED_TRACE(space);
        expect_near(reader.colour("rgb", {1, 1, 1}, ColourOf::Surface, space), Rgb(1.0f), 1e-5f);
        EXPECT_NEAR(luminance(reader.colour("rgb", {1, 1, 1}, ColourOf::Light, space)), 1, 1e-3);
        // A green inside of sRGB's gamut is a purer one there.
        EXPECT_GT(reader.colour("rgb", {0, 1, 0}, ColourOf::Surface, space).y, 1);
    }
}

TEST(PbrtColours, SpectraOfSurfacesAreTheirValues) {
    Reader reader;
    expect_near(reader.colour("spectrum", {300, 0.5, 900, 0.5}, ColourOf::Surface), Rgb(0.5f),
                1e-4f);
    EXPECT_GT(reader.colour("spectrum", {600, 0, 610, 1, 800, 1}, ColourOf::Surface).x, 0.5f);
    EXPECT_NEAR(luminance(reader.colour("spectrum", {300, 7, 900, 7}, ColourOf::Light)), 1, 1e-4);
    EXPECT_THROW(reader.colour("spectrum", {300, 7, 900}, ColourOf::Light), InputError);
}

TEST(PbrtColours, FilesOfSpectra) {
    const files::TemporaryFolder folder;
    folder.write("half.spd", "# a comment\n300 0.5\n900 0.5\n");
    folder.write("broken.spd", "no numbers");
    Reader reader(folder.path().string());
    expect_near(reader.named("half.spd", ColourOf::Surface), Rgb(0.5f), 1e-4f);
    EXPECT_THROW(reader.named("broken.spd", ColourOf::Surface), InputError);
    EXPECT_THROW(reader.named("missing.spd", ColourOf::Surface), InputError);
}

TEST(PbrtColours, GlassesDisperseByTheirNumberOfAbbe) {
    const auto glass = pbrt::glass_by_name("glass-BK7");
    ASSERT_TRUE(glass.has_value());
    const auto index = [&](double micrometres) {
        return glass->cauchy_a() + glass->cauchy_b() / (micrometres * micrometres);
    };
    EXPECT_NEAR(index(0.58756), 1.5168, 1e-9);
    EXPECT_NEAR((index(0.58756) - 1) / (index(0.48613) - index(0.65627)), 64.17, 1e-6);
    EXPECT_FALSE(pbrt::glass_by_name("glass-XX").has_value());
    EXPECT_EQ(pbrt::metal_preset("metal-Au-k"), "gold");
    EXPECT_EQ(pbrt::metal_preset("spds/Ag.eta.spd"), "silver");
    EXPECT_FALSE(pbrt::metal_preset("metal-CuZn-eta").has_value());
}

}  // namespace
}  // namespace lxs::test::pbrt_parameter_test
