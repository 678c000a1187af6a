// Protects that the strategies of `path` share each light path: with and without next-event
// estimation, with any choice of lights or roulette, and through surfaces that light passes
// straight, the expectation is the same. z-tests at 4.5 standard errors: over all comparisons here
// a false alarm has a probability below 1e-3; a lamp counted twice would be off by hundreds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "path_render.h"

namespace lxs::test::path_agreement_test {
namespace {

constexpr double kLargestZ = 4.5;
constexpr int kPasses = 512;

std::string lamp(double half_side) {
    return "AttributeBegin\nAreaLightSource \"area\" \"color L\" [5 4 3] \"float power\" [0] "
           "\"float efficacy\" [0]\n" +
           square(3, half_side, true) + "AttributeEnd\n";
}

std::string floor_of(const std::string& material) {
    return "AttributeBegin\n" + material + "\n" + square(0, 4) + "AttributeEnd\n";
}

std::string sheet(const std::string& material) {
    return "AttributeBegin\n" + material + "\n" + square(2, 4) + "AttributeEnd\n";
}

constexpr const char* kMatte = "Material \"matte\" \"color Kd\" [0.8 0.6 0.4]";
constexpr const char* kGlossy =
    "Material \"glossy\" \"color Kd\" [0.3 0.3 0.3] \"color Ks\" [0.5 0.5 0.5] "
    "\"float uroughness\" [0.15] \"float vroughness\" [0.15]";
constexpr const char* kNull = "Material \"null\"";
constexpr const char* kArchitectural =
    "Material \"glass\" \"bool architectural\" [\"true\"] \"float index\" [1.5]";

PathSettings without_direct_light() {
    PathSettings settings;
    settings.direct_light_sampling = false;
    return settings;
}

void expect_agreement(const std::string& scene, const PathSettings& a, const PathSettings& b) {
    const MeanRadiance first = render_mean(scene, a, kPasses, 1);
    const MeanRadiance second = render_mean(scene, b, kPasses, 2);
    EXPECT_GT(first.mean.x, 0);
    EXPECT_LT(z_score(first, second), kLargestZ)
        << "means " << first.mean << " and " << second.mean;
}

TEST(PathAgreement, DirectLightSamplingDoesNotChangeTheMean) {
    for (const char* material : {kMatte, kGlossy}) {
        const std::string scene = camera_above(1) + lamp(1.5) + floor_of(material) + "WorldEnd\n";
        expect_agreement(scene, {}, without_direct_light());
    }
}

// The scattered ray that meets the lamp behind the sheet shares with the shadow ray that passes it.
TEST(PathAgreement, StraightSheetBeforeTheLampIsNotCountedTwice) {
    for (const char* material : {kMatte, kGlossy}) {
        for (const char* pane : {kNull, kArchitectural}) {
            const std::string scene =
                camera_above(1) + lamp(1.5) + floor_of(material) + sheet(pane) + "WorldEnd\n";
            expect_agreement(scene, {}, without_direct_light());
        }
    }
}

TEST(PathAgreement, StraightSheetBeforeTheSkyIsNotCountedTwice) {
    const std::string scene = camera_above(1) + "LightSource \"infinite\" \"color L\" [2 1 1]\n" +
                              floor_of(kGlossy) + sheet(kArchitectural) + "WorldEnd\n";
    expect_agreement(scene, {}, without_direct_light());
}

TEST(PathAgreement, NullSheetChangesNothing) {
    const std::string head = camera_above(1) + lamp(1.5) + floor_of(kGlossy);
    const MeanRadiance bare = render_mean(head + "WorldEnd\n", {}, kPasses, 1);
    const MeanRadiance behind = render_mean(head + sheet(kNull) + "WorldEnd\n", {}, kPasses, 2);
    EXPECT_LT(z_score(bare, behind), kLargestZ) << bare.mean << " and " << behind.mean;
}

// At the last bounce a scattered ray may still pass the sheet, as the shadow ray does.
TEST(PathAgreement, StraightPassageIsNoBounce) {
    PathSettings one;
    one.max_depth = 1;
    PathSettings one_scattered = one;
    one_scattered.direct_light_sampling = false;
    const std::string scene =
        camera_above(1) + lamp(1.5) + floor_of(kMatte) + sheet(kNull) + "WorldEnd\n";
    expect_agreement(scene, one, one_scattered);
    const std::string bare = camera_above(1) + lamp(1.5) + floor_of(kMatte) + "WorldEnd\n";
    const MeanRadiance through = render_mean(scene, one, kPasses, 1);
    const MeanRadiance free = render_mean(bare, one, kPasses, 2);
    EXPECT_LT(z_score(through, free), kLargestZ);
}

TEST(PathAgreement, HalfNullMaterialSharesItsLight) {
    const std::string mix =
        "MakeNamedMaterial \"a\" \"string type\" [\"matte\"] \"color Kd\" [.5 .5 .5]\n"
        "MakeNamedMaterial \"b\" \"string type\" [\"null\"]\n"
        "Material \"mix\" \"string namedmaterial1\" [\"a\"] \"string namedmaterial2\" [\"b\"] "
        "\"float amount\" [0.5]";
    const std::string scene =
        camera_above(1) + lamp(1.5) + floor_of(kMatte) + sheet(mix) + "WorldEnd\n";
    expect_agreement(scene, {}, without_direct_light());
}

TEST(PathAgreement, RouletteDoesNotChangeTheMean) {
    const std::string scene = camera_above(1) + lamp(0.8) + floor_of(kMatte) +
                              "Material \"matte\" \"color Kd\" [0.9 0.9 0.9]\n" +
                              square(3.2, 4, true) + "WorldEnd\n";
    PathSettings none;
    none.roulette = RouletteStrategy::None;
    PathSettings fixed;
    fixed.roulette = RouletteStrategy::Probability;
    expect_agreement(scene, {}, none);
    expect_agreement(scene, fixed, none);
}

TEST(PathAgreement, AnyChoiceOfLightsGivesTheSameMean) {
    const std::string scene =
        camera_above(1) + lamp(1.0) +
        "LightSource \"point\" \"point from\" [2 0 1] \"color L\" [3 9 3]\n"
        "LightSource \"infinite\" \"color L\" [0.3 0.3 0.9]\n"
        "LightSource \"spot\" \"point from\" [0 2 2] \"point to\" [0 0 0] \"color L\" [8 1 1]\n" +
        floor_of(kGlossy) + "WorldEnd\n";
    PathSettings all;
    all.lights = LightStrategy::All;
    for (const LightStrategy strategy : {LightStrategy::Power, LightStrategy::Uniform,
                                         LightStrategy::LogPower, LightStrategy::Learned}) {
        PathSettings one;
        one.lights = strategy;
        expect_agreement(scene, all, one);
    }
}

TEST(PathAgreement, CausticThroughRealGlassComesFromScatteredRaysAlone) {
    const std::string scene = camera_above(1.5) + lamp(1.5) + floor_of(kMatte) +
                              "Material \"glass\" \"float index\" [1.5]\nTranslate 0.6 0 0.6\n"
                              "Shape \"sphere\" \"float radius\" [0.5]\nWorldEnd\n";
    expect_agreement(scene, {}, without_direct_light());
}

}  // namespace
}  // namespace lxs::test::path_agreement_test
