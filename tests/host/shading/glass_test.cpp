// Glass: refraction is adjoint up to the squared index ratio, directions obey Snell's law, and
// architectural glass treats eye paths, photons and shadow rays alike.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs::glass_test {
namespace {

class GlassTest : public ::testing::Test {
  protected:
    /// The transmitted sample, weighted with the probability of choosing it: T itself.
    BsdfSample transmitted(const Bsdf& bsdf, const Vec3& wo, Transport transport) {
        BsdfSample sample;
        constexpr float kBelowOne = 0x1.fffffep-1f;
        EXPECT_TRUE(bsdf.sample(wo, {0, 0}, kBelowOne, transport, kAllLobes, sample));
        EXPECT_TRUE(sample.transmitted);
        return sample;
    }

    ShadingFixture scene_;
    BsdfMemory memory_;
};

TEST_F(GlassTest, ObeysSnellsLaw) {
    const auto glass = scene_.make_material("glass", {number("index", 1.5)});
    const Bsdf& bsdf = *memory_.scatter(*glass, shading_point());
    for (const float sine : {0.0f, 0.3f, 0.8f, 0.999f}) {
        const Vec3 wo(sine, 0, std::sqrt(1 - sine * sine));
        const Vec3 wi = transmitted(bsdf, wo, Transport::Power).wi;
        EXPECT_NEAR(wi.x, -sine / 1.5f, 1e-6f);
        EXPECT_LT(wi.z, 0);
        const Vec3 back = transmitted(bsdf, wi, Transport::Power).wi;
        EXPECT_NEAR((back - wo).length(), 0, 1e-3f);
    }
}

// A camera or a lamp inside of glass is right only if radiance scales and power does not.
TEST_F(GlassTest, RadianceScalesByTheSquaredIndexRatioAndPowerDoesNot) {
    const auto glass = scene_.make_material("glass", {number("index", 1.6)});
    const Bsdf& bsdf = *memory_.scatter(*glass, shading_point());
    UniformSource u(2);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 wo = u.direction();
        if (wo.z < 0 && 1 - wo.z * wo.z > 1 / 1.6f / 1.6f) continue;  // total reflection
        const float radiance = transmitted(bsdf, wo, Transport::Radiance).weight.x;
        const float power = transmitted(bsdf, wo, Transport::Power).weight.x;
        const float ratio = wo.z > 0 ? 1 / 1.6f : 1.6f;
        ASSERT_NEAR(radiance / power, ratio * ratio, 1e-4f);
    }
}

TEST_F(GlassTest, TransmitsTheSameShareBothWays) {
    const auto glass = scene_.make_material("glass", {number("index", 1.5)});
    const Bsdf& bsdf = *memory_.scatter(*glass, shading_point());
    for (const float cosine : {0.1f, 0.5f, 0.9f}) {
        const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        const Vec3 wi = transmitted(bsdf, wo, Transport::Power).wi;
        const auto share = [&](const Vec3& w) {
            UniformSource u(1);
            int passed = 0;
            for (int i = 0; i < 40000; ++i) {
                BsdfSample sample;
                EXPECT_TRUE(bsdf.sample(w, {0, 0}, u(), Transport::Power, kAllLobes, sample));
                passed += sample.transmitted;
            }
            return passed / 40000.0;
        };
        EXPECT_NEAR(share(wo), share(wi), 1e-4);
    }
}

TEST_F(GlassTest, ReflectsTotallyBeyondTheCriticalAngle) {
    const auto glass = scene_.make_material("glass", {number("index", 1.5)});
    const Bsdf& bsdf = *memory_.scatter(*glass, shading_point());
    const Vec3 wo = Vec3(0.8f, 0, -0.6f);
    for (const float u : {0.0f, 0.5f, 0.99f}) {
        BsdfSample sample;
        ASSERT_TRUE(bsdf.sample(wo, {0, 0}, u, Transport::Radiance, kAllLobes, sample));
        EXPECT_FALSE(sample.transmitted);
        EXPECT_EQ(sample.weight, Rgb(1.0f));
    }
}

TEST_F(GlassTest, ArchitecturalGlassPassesStraightAndShadowRaysAgree) {
    const Rgb tint(0.9f, 0.5f, 0.2f);
    for (const bool pane : {false, true}) {
        const auto glass = scene_.make_material(
            "glass", {flag("architectural", true), flag("pane", pane), color("Kt", tint)});
        ASSERT_TRUE(glass->facts().straight);
        const ShadingPoint point = shading_point();
        const Bsdf& bsdf = *memory_.scatter(*glass, point);
        UniformSource u(3);
        for (int i = 0; i < 200; ++i) {
            const Vec3 wo = u.direction();
            Rgb sum(0.0f);
            const int samples = 2000;
            for (int k = 0; k < samples; ++k) {
                BsdfSample sample;
                const float choice = (static_cast<float>(k) + 0.5f) / samples;
                if (!bsdf.sample(wo, {0, 0}, choice, Transport::Radiance, kAllLobes, sample))
                    continue;
                if (!sample.straight) continue;
                ASSERT_EQ(sample.wi, -wo);
                sum += sample.weight / samples;
            }
            const Rgb straight = glass->straight_transmittance(point, -wo);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(sum[c], straight[c], 2e-3f);
        }
    }
}

// Both faces reflect F, and what goes to and fro between them comes out (a series of F squared).
TEST_F(GlassTest, APaneHasTwoFaces) {
    const auto pane =
        scene_.make_material("glass", {flag("architectural", true), flag("pane", true)});
    const Bsdf& bsdf = *memory_.scatter(*pane, shading_point());
    const double face = 0.04;
    for (const float side : {1.0f, -1.0f}) {
        const MeanWeight all =
            mean_weight(bsdf, Vec3(0, 0, side), Transport::Radiance, 20000, side > 0 ? 1 : 2);
        EXPECT_NEAR(all.mean.x, 1, 1e-4);
        EXPECT_NEAR(pane->straight_transmittance(shading_point(), {0, 0, side}).x,
                    (1 - face) / (1 + face), 1e-5);
    }
}

TEST_F(GlassTest, SolidGlassBlocksShadowRays) {
    const auto glass = scene_.make_material("glass");
    EXPECT_FALSE(glass->facts().straight);
    EXPECT_EQ(glass->straight_transmittance(shading_point(), {0, 0, 1}), Rgb(0.0f));
}

TEST_F(GlassTest, Glass2TakesItsIndexFromTheMedia) {
    const Medium water(Rgb(0.0f), 1.33f), dense(Rgb(0.0f), 1.7f);
    const auto glass = scene_.make_material("glass2");
    ShadingPoint point = shading_point();
    point.interior = &dense;
    point.exterior = &water;
    const Bsdf& bsdf = *memory_.scatter(*glass, point);
    const Vec3 wo(0.6f, 0, 0.8f);
    EXPECT_NEAR(transmitted(bsdf, wo, Transport::Power).wi.x, -0.6f * 1.33f / 1.7f, 1e-5f);
    // Without media there is nothing to refract at.
    const Bsdf& nothing = *memory_.scatter(*glass, shading_point());
    EXPECT_NEAR((transmitted(nothing, wo, Transport::Radiance).wi + wo).length(), 0, 1e-5f);
}

/// A point that a pass of a spectral render looks at.
ShadingPoint point_at(const Wavelengths& wavelengths, std::int8_t component = kAllComponents) {
    ShadingPoint point = shading_point();
    point.texture.wavelengths = &wavelengths;
    point.component = component;
    return point;
}

// Each component leaves in its own direction, by its own index, and what is left of the others is
// black: a prism draws a spectrum, and the right one.
TEST_F(GlassTest, DispersionBendsEachComponentByItsOwnIndex) {
    const auto glass =
        scene_.make_material("glass", {number("index", 1.5), number("cauchyb", .02)});
    EXPECT_TRUE(glass->facts().disperses);
    const Wavelengths wavelengths = wavelengths_of_pass(0, 3);
    const Bsdf& bsdf = *memory_.scatter(*glass, point_at(wavelengths));
    const Vec3 wo(0.8f, 0, 0.6f);
    UniformSource u(4);
    std::array<int, 3> met{};
    for (int i = 0; i < 3000; ++i) {
        BsdfSample sample;
        ASSERT_TRUE(bsdf.sample(wo, u.pair(), u(), Transport::Power, kAllLobes, sample));
        if (!sample.transmitted) {
            EXPECT_EQ(sample.component, kAllComponents);
            continue;
        }
        ASSERT_GE(sample.component, 0);
        const auto c = static_cast<std::uint8_t>(sample.component);
        ++met[c];
        const double micrometres = wavelengths.nm[c] / 1000;
        EXPECT_NEAR(sample.wi.x, -0.8 / (1.5 + 0.02 / (micrometres * micrometres)), 1e-5);
        for (int other = 0; other < 3; ++other)
            EXPECT_EQ(sample.weight[other] > 0, other == sample.component);
    }
    for (const int count : met)
        EXPECT_NEAR(count, 950, 150);
}

// What a path loses by the choice it gains in weight: the mean is that of a glass that doesn't
// disperse, component by component, for paths that carry all and for those that carry one.
TEST_F(GlassTest, DispersionKeepsTheMeanOfEachComponent) {
    const auto glass =
        scene_.make_material("glass", {number("index", 1.4), number("cauchyb", .03)});
    const Wavelengths wavelengths = wavelengths_of_pass(0, 1);
    for (const Vec3& wo : {Vec3(0.6f, 0, 0.8f), Vec3(0.6f, 0, -0.8f)}) {
        for (const Transport transport : {Transport::Radiance, Transport::Power}) {
            for (std::int8_t carried = kAllComponents; carried < 3; ++carried) {
                const Bsdf& bsdf = *memory_.scatter(*glass, point_at(wavelengths, carried));
                const MeanWeight mean = mean_weight(bsdf, wo, transport, 200'000, 9);
                for (std::int8_t c = 0; c < 3; ++c) {
                    if (carried != kAllComponents && carried != c) {
                        EXPECT_EQ(mean.mean[c], 0);
                        continue;
                    }
                    const double um = wavelengths.nm[static_cast<std::uint8_t>(c)] / 1000;
                    const auto plain =
                        scene_.make_material("glass", {number("index", 1.4 + 0.03 / (um * um))});
                    const Bsdf& one = *memory_.scatter(*plain, shading_point());
                    const MeanWeight expected = mean_weight(one, wo, transport, 200'000, 10);
                    EXPECT_NEAR(mean.mean[c], expected.mean[c],
                                5 * (mean.deviation[c] + expected.deviation[c]) + 1e-5f);
                }
            }
        }
    }
}

TEST_F(GlassTest, WithoutWavelengthsTheMiddleOfTheSpectrumStandsForAll) {
    const auto glass =
        scene_.make_material("glass", {number("index", 1.5), number("cauchyb", .02)});
    const Bsdf& bsdf = *memory_.scatter(*glass, shading_point());
    const BsdfSample sample = transmitted(bsdf, {0.8f, 0, 0.6f}, Transport::Power);
    EXPECT_NEAR(sample.wi.x, -0.8 / (1.5 + 0.02 / (0.55 * 0.55)), 1e-5);
    EXPECT_EQ(sample.component, kAllComponents);
}

// One direction of rough glass serves all components: each of them must see the glass of its own
// index, whether the path carries the others or not.
TEST_F(GlassTest, RoughDispersionShowsEachComponentItsOwnGlass) {
    const std::vector<ParameterValue> rough{number("uroughness", 0.2), number("vroughness", 0.2)};
    const auto made = [&](std::vector<ParameterValue> more) {
        more.insert(more.end(), rough.begin(), rough.end());
        return scene_.make_material("roughglass", std::move(more));
    };
    const auto glass =
        made({number("index", 1.4), number("cauchyb", .03), flag("dispersion", true)});
    EXPECT_TRUE(glass->facts().disperses);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    const Wavelengths wavelengths = wavelengths_of_pass(0, 1);
    UniformSource u(12);
    for (std::int8_t carried = kAllComponents; carried < 3; ++carried) {
        const Bsdf& bsdf = *memory_.scatter(*glass, point_at(wavelengths, carried));
        for (int c = 0; c < 3; ++c) {
            const double um = wavelengths.nm[static_cast<std::size_t>(c)] / 1000;
            const auto plain = made({number("index", 1.4 + 0.03 / (um * um))});
            const Bsdf& one = *memory_.scatter(*plain, shading_point());
            const bool there = carried == kAllComponents || carried == c;
            for (int i = 0; i < 300; ++i) {
                const Vec3 wo = u.direction(), wi = u.direction();
                const float expected =
                    there ? one.evaluate(wo, wi, Transport::Radiance, kAllLobes)[c] : 0;
                ASSERT_NEAR(bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes)[c], expected,
                            1e-4f * expected);
            }
            const MeanWeight mean = mean_weight(bsdf, {0.6f, 0, 0.8f}, Transport::Power, 40'000, 9);
            const MeanWeight of_one =
                mean_weight(one, {0.6f, 0, 0.8f}, Transport::Power, 40'000, 10);
            EXPECT_NEAR(mean.mean[c], there ? of_one.mean[c] : 0,
                        5 * (mean.deviation[c] + of_one.deviation[c]));
        }
    }
}

// With hardly any roughness the components part as at smooth glass: by Snell's law.
TEST_F(GlassTest, NearlySmoothRoughGlassBendsByTheIndexOfTheComponent) {
    const auto glass = scene_.make_material(
        "roughglass", {number("index", 1.5), number("cauchyb", .04), flag("dispersion", true),
                       number("uroughness", 0), number("vroughness", 0)});
    const Wavelengths wavelengths = wavelengths_of_pass(0, 3);
    UniformSource u(5);
    for (std::int8_t c = 0; c < 3; ++c) {
        const Bsdf& bsdf = *memory_.scatter(*glass, point_at(wavelengths, c));
        const double um = wavelengths.nm[static_cast<std::uint8_t>(c)] / 1000;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 20000; ++i) {
            BsdfSample sample;
            if (!bsdf.sample({0.6f, 0, 0.8f}, u.pair(), u(), Transport::Power, kAllLobes, sample))
                continue;
            if (!sample.transmitted || std::abs(sample.wi.y) > 0.01f) continue;
            sum += sample.wi.x;
            ++count;
        }
        EXPECT_NEAR(sum / count, -0.6 / (1.5 + 0.04 / (um * um)), 1e-3);
    }
}

// glass2 takes its index from the volumes on its sides.
TEST_F(GlassTest, VolumesDisperseByTheirFresnelTexture) {
    scene_.fresnels["flint"] =
        scene_.make_fresnel("cauchy", {number("cauchya", 1.728), number("cauchyb", 0.0134)});
    const auto flint = scene_.make_medium("clear", {texture("fresnel", "flint")});
    EXPECT_NEAR(flint->index_curve().at(500), 1.728 + 0.0134 / 0.25, 1e-5);
    const auto glass = scene_.make_material("glass2", {flag("dispersion", true)});
    const Wavelengths wavelengths = wavelengths_of_pass(0, 2);
    ShadingPoint point = point_at(wavelengths, 1);
    point.interior = flint.get();
    const BsdfSample sample =
        transmitted(*memory_.scatter(*glass, point), {0.8f, 0, 0.6f}, Transport::Power);
    EXPECT_EQ(sample.component, 1);
    EXPECT_NEAR(sample.wi.x, -0.8f / flint->index_curve().at(wavelengths.nm[1]), 1e-5);
}

}  // namespace
}  // namespace lxs::glass_test
