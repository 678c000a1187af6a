// Glass: refraction is adjoint up to the squared index ratio, directions obey Snell's law, and
// architectural glass treats eye paths, photons and shadow rays alike.
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs {
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
    const auto glass =
        scene_.make_material("glass", {flag("architectural", true), color("Kt", tint)});
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
            if (!bsdf.sample(wo, {0, 0}, choice, Transport::Radiance, kAllLobes, sample)) continue;
            if (!sample.straight) continue;
            ASSERT_EQ(sample.wi, -wo);
            sum += sample.weight / samples;
        }
        const Rgb straight = glass->straight_transmittance(point, -wo);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(sum[c], straight[c], 2e-3f);
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

}  // namespace
}  // namespace lxs
