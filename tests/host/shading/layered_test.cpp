// Layers of materials against closed forms, and the contract of a Bsdf that estimates its value.
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "bsdfs/fresnel.h"
#include "bsdfs/layered_bsdf.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"

namespace lxs::layered_test {
namespace {

using shading::LayeredBsdf;

constexpr float kIndex = 1.5f;

Vec3 at_angle(float degrees, float azimuth) {
    const float theta = degrees * kPi / 180;
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth),
            std::cos(theta)};
}

/// Scatters diffusely to both sides of z = 0: `r` back, `t` through.
class Paper final : public Bsdf {
  public:
    Paper(float r, float t) : r_(r), t_(t) {}
    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask) const override {
        return Rgb(wo.z * wi.z > 0 ? r_ : t_) * kInvPi;
    }
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask) const override {
        return (wo.z * wi.z > 0 ? r_ : t_) / (r_ + t_) * std::abs(wi.z) * kInvPi;
    }
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport, LobeMask,
                BsdfSample& sample) const override {
        const bool through = u_lobe * (r_ + t_) >= r_;
        Vec3 wi = square_to_cosine_hemisphere(u);
        if ((wo.z > 0) == through) wi.z = -wi.z;
        sample = {wi, Rgb(r_ + t_), pdf(wo, wi, kDiffuse), kDiffuse, through, false};
        return true;
    }
    Rgb albedo(const Vec3&, LobeMask) const override { return Rgb(r_ + t_); }

  private:
    float r_, t_;
};

/// Share of diffuse light that crosses a gap of this thickness: twice the exponential integral E3.
double diffuse_crossing(double thickness) {
    constexpr int kSteps = 10000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        sum += 2 * cosine * std::exp(-thickness / cosine) / kSteps;
    }
    return sum;
}

// Lambertian to both sides: all light between the layers is diffuse, and the closed form is that of
// a pile of plates (Stokes 1862). Paths here have several vertices at which they could be joined.
TEST(LayeredPaper, AddsUpLikeAPileOfPlates) {
    const float r1 = 0.3f, t1 = 0.6f, r2 = 0.5f, t2 = 0.4f;
    const Paper first(r1, t1), second(r2, t2);
    for (const float thickness : {0.0f, 0.3f}) {
        SCOPED_TRACE(thickness);
        LayeredBsdf::Stack stack;
        stack.layers = {&first, &second};
        stack.count = 2;
        stack.transmits = true;
        stack.thickness = thickness;
        const Vec3 wo = at_angle(40, 0), up = at_angle(60, 2), down = -at_angle(30, 1);
        constexpr int kPlaces = 200000;
        double reflected = 0, passed = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const LayeredBsdf bsdf(stack, Vec3(static_cast<float>(i), 0, 0), {0, 0, 1}, {0, 0, 1});
            reflected += bsdf.evaluate(wo, up, Transport::Radiance, kAllLobes).x;
            passed += bsdf.evaluate(wo, down, Transport::Radiance, kAllLobes).x;
        }
        const double gap = diffuse_crossing(thickness);
        const double between = 1 - double{r1} * r2 * gap * gap;
        EXPECT_NEAR(reflected / kPlaces * kPi, r1 + double{t1} * t1 * r2 * gap * gap / between,
                    0.004);
        EXPECT_NEAR(passed / kPlaces * kPi, double{t1} * t2 * gap / between, 0.004);
    }
}

/// As written; a white lamp shows another colour of it.
const Rgb kTint(0.5f, 0.3f, 0.1f);

class LayeredTest : public ::testing::Test {
  protected:
    LayeredTest() {
        scene_.materials["glass"] = scene_.make_material("glass", {number("index", kIndex)});
        scene_.materials["white"] = scene_.make_material("matte", {color("Kd", Rgb(0.8f))});
        scene_.materials["tinted"] = scene_.make_material("matte", {color("Kd", kTint)});
        scene_.materials["mirror"] = scene_.make_material("mirror", {color("Kr", Rgb(0.7f))});
        scene_.materials["metal"] = scene_.make_material("metal", {number("uroughness", 0.3)});
    }
    std::shared_ptr<const Material> layered(const std::string& front, const std::string& back,
                                            double opacity = 1) {
        return scene_.make_material("layered",
                                    {text("namedmaterial1", front), text("namedmaterial2", back),
                                     number("opacity1", opacity)});
    }
    /// Mean of many estimates of f(wo, wi) at neighbouring places.
    Rgb mean_value(const Material& material, const Vec3& wo, const Vec3& wi, Transport transport,
                   Rgb& deviation) {
        constexpr int kPlaces = 40000;
        double sum[3] = {}, squares[3] = {};
        for (int i = 0; i < kPlaces; ++i) {
            ShadingPoint point = shading_point();
            point.texture.p.x = static_cast<float>(i);
            BsdfMemory memory;
            const Rgb f = memory.scatter(material, point)->evaluate(wo, wi, transport, kAllLobes);
            for (int c = 0; c < 3; ++c) {
                sum[c] += f[c];
                squares[c] += double{f[c]} * f[c];
            }
        }
        Rgb mean;
        for (int c = 0; c < 3; ++c) {
            const double m = sum[c] / kPlaces;
            mean[c] = static_cast<float>(m);
            deviation[c] = static_cast<float>(
                std::sqrt(std::max(0.0, squares[c] / kPlaces - m * m) / kPlaces));
        }
        return mean;
    }
    void expect_mean(const Material& material, const Vec3& wo, const Vec3& wi,
                     const Rgb& expected) {
        Rgb deviation;
        const Rgb mean = mean_value(material, wo, wi, Transport::Radiance, deviation);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mean[c], expected[c], 4.5f * deviation[c] + 1e-4f * expected[c]);
    }

    ShadingFixture scene_;
};

/// Mean reflectance of the interface for diffuse light from within.
double internal_reflectance() {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) / kSteps;  // squared cosine
        sum += shading::fresnel_dielectric(static_cast<float>(std::sqrt(s)), 1 / kIndex);
    }
    return sum / kSteps;
}

// Lambert under smooth glass: what comes in is (1 - F), what goes out is spread by n^2, and the
// light between is a geometric series (Saunderson 1942).
TEST_F(LayeredTest, MatteUnderGlassIsSaundersonsFormula) {
    const auto coated = layered("glass", "tinted");
    const Vec3 wo = at_angle(30, 0), wi = at_angle(60, 2);
    const double passed = (1 - double{shading::fresnel_dielectric(wo.z, kIndex)}) *
                          (1 - double{shading::fresnel_dielectric(wi.z, kIndex)});
    Rgb expected;
    for (int c = 0; c < 3; ++c) {
        const double kd = colour_of_reflectance(kTint)[c];
        expected[c] = static_cast<float>(kd / kPi * passed / (kIndex * kIndex) /
                                         (1 - kd * internal_reflectance()));
    }
    expect_mean(*coated, wo, wi, expected);
}

// Both layers Lambertian, the first one with gaps: a geometric series of bounces between them.
TEST_F(LayeredTest, GapsLetLightThroughInStraightLines) {
    constexpr float kOpacity = 0.4f, kFirst = 0.8f;
    const auto dusty = layered("white", "tinted", kOpacity);
    const Vec3 wo = at_angle(20, 0), wi = at_angle(70, 1);
    Rgb expected;
    for (int c = 0; c < 3; ++c) {
        const float second = colour_of_reflectance(kTint)[c];
        const float open = 1 - kOpacity;
        const float r = kOpacity * kFirst + open * open * second / (1 - kOpacity * kFirst * second);
        expected[c] = r * kInvPi;
    }
    expect_mean(*dusty, wo, wi, expected);
}

TEST_F(LayeredTest, MirrorUnderGlassIsOneSpecularLobe) {
    const auto stack = layered("glass", "mirror");
    BsdfMemory memory;
    const Bsdf& bsdf = *memory.scatter(*stack, shading_point());
    EXPECT_EQ(bsdf.lobes(), kSpecular);
    const Vec3 wo = at_angle(50, 0);
    const float f = shading::fresnel_dielectric(wo.z, kIndex);
    const float expected = f + (1 - f) * (1 - f) * 0.7f / (1 - 0.7f * f);
    const MeanWeight mean = mean_weight(bsdf, wo, Transport::Radiance, 200000, 3);
    EXPECT_NEAR(mean.mean.x, expected, 4.5f * mean.deviation.x);
    BsdfSample sample;
    UniformSource u(1);
    for (int i = 0; i < 100; ++i) {
        const Vec2 uv = u.pair();
        if (!bsdf.sample(wo, uv, u(), Transport::Radiance, kAllLobes, sample)) continue;
        EXPECT_NEAR((sample.wi - Vec3(-wo.x, -wo.y, wo.z)).length(), 0, 1e-5f);
        EXPECT_FALSE(sample.straight);
    }
}

TEST_F(LayeredTest, SidesSeeTheLayersInOppositeOrder) {
    const auto stack = layered("white", "tinted");  // opaque: each side shows one
    const Vec3 up = at_angle(10, 0), down(0, 0, -1);
    expect_mean(*stack, up, at_angle(40, 1), Rgb(0.8f) * kInvPi);
    expect_mean(*stack, down, -at_angle(40, 1), colour_of_reflectance(kTint) * kInvPi);
    EXPECT_FALSE(stack->facts().transmits);
    EXPECT_FALSE(stack->facts().straight);
}

TEST_F(LayeredTest, ShadowRaysPassTheGapsOfAllLayers) {
    const auto veil = scene_.make_material(
        "layered", {text("namedmaterial1", "white"), text("namedmaterial2", "tinted"),
                    number("opacity1", 0.25), number("opacity2", 0.5)});
    ASSERT_TRUE(veil->facts().straight);
    const float share = veil->straight_transmittance(shading_point(), {0, 0, 1}).x;
    EXPECT_NEAR(share, 0.75f * 0.5f, 1e-6f);
    BsdfMemory memory;
    const Bsdf& bsdf = *memory.scatter(*veil, shading_point());
    UniformSource u(2);
    double passed = 0;
    constexpr int kSamples = 200000;
    for (int i = 0; i < kSamples; ++i) {
        BsdfSample sample;
        const Vec2 uv = u.pair();
        if (bsdf.sample({0, 0, 1}, uv, u(), Transport::Radiance, kAllLobes, sample) &&
            sample.straight) {
            EXPECT_EQ(sample.wi, Vec3(0, 0, -1));
            passed += sample.weight.x;
        }
    }
    EXPECT_NEAR(passed / kSamples, share, 0.01);
}

TEST_F(LayeredTest, AsksTwiceAnswersAlike) {
    const auto stack = layered("glass", "white");
    BsdfMemory memory;
    const Bsdf& bsdf = *memory.scatter(*stack, shading_point());
    const Vec3 wo = at_angle(30, 0), wi = at_angle(60, 2);
    const Rgb f = bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes);
    EXPECT_EQ(bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes), f);
    ShadingPoint elsewhere = shading_point();
    elsewhere.texture.p.y = 1;
    EXPECT_NE(memory.scatter(*stack, elsewhere)->evaluate(wo, wi, Transport::Radiance, kAllLobes),
              f);
}

TEST_F(LayeredTest, BothTransportsAreAdjoint) {
    const auto stack = layered("glass", "metal");
    const Vec3 a = at_angle(25, 0), b = at_angle(35, 2.6f);
    Rgb deviation, other_deviation;
    const Rgb forth = mean_value(*stack, a, b, Transport::Radiance, deviation);
    const Rgb back = mean_value(*stack, b, a, Transport::Power, other_deviation);
    EXPECT_GT(forth.x, 0.01f);
    EXPECT_NEAR(forth.x, back.x, 4.5f * (deviation.x + other_deviation.x));
}

TEST_F(LayeredTest, SamplesFollowTheDensityAndWeighTheValue) {
    int seed = 0;
    for (const auto& stack : {layered("glass", "tinted"), layered("metal", "white", 0.5),
                              layered("white", "metal", 0.3)}) {
        BsdfMemory memory;
        const ShadingPoint point = shading_point({0.3f, -0.5f, 0.8f}, {0.42f, -0.4f, 0.8f});
        const Bsdf& bsdf = *memory.scatter(*stack, point);
        for (const float degrees : {20.0f, 65.0f, 140.0f}) {
            const Vec3 wo = Frame(point.ns).to_world(at_angle(degrees, degrees));
            EXPECT_GT(chi_square_p_value(bsdf, wo, point.ng, kAllLobes, ++seed), 1e-5);
            UniformSource u(seed);
            for (int i = 0; i < 500; ++i) {
                BsdfSample sample;
                const Vec2 uv = u.pair();
                if (!bsdf.sample(wo, uv, u(), Transport::Power, kAllLobes, sample)) continue;
                if (sample.lobe == kSpecular) continue;
                ASSERT_NEAR(sample.pdf, bsdf.pdf(wo, sample.wi, kAllLobes), 2e-3f * sample.pdf);
                const Rgb f = bsdf.evaluate(wo, sample.wi, Transport::Power, kAllLobes);
                const float weight = f.x * std::abs(sample.wi.dot(point.ns)) / sample.pdf;
                ASSERT_NEAR(sample.weight.x, weight, 2e-3f * weight + 1e-6f);
            }
        }
    }
}

TEST_F(LayeredTest, SendsBackNoMoreThanArrives) {
    scene_.materials["perfect"] = scene_.make_material("matte", {color("Kd", Rgb(1.0f))});
    for (const auto& stack : {layered("glass", "perfect"), layered("glass", "mirror"),
                              layered("perfect", "perfect", 0.5)}) {
        BsdfMemory memory;
        const Bsdf& bsdf = *memory.scatter(*stack, shading_point());
        for (const float degrees : {5.0f, 50.0f, 85.0f}) {
            const MeanWeight mean =
                mean_weight(bsdf, at_angle(degrees, 1), Transport::Power, 100000, 4);
            EXPECT_LE(mean.mean.x, 1 + 4.5f * mean.deviation.x);
        }
    }
}

// Nothing is lost where nothing absorbs: a white base under clear glass.
TEST_F(LayeredTest, WhiteUnderGlassStaysWhite) {
    scene_.materials["perfect"] = scene_.make_material("matte", {color("Kd", Rgb(1.0f))});
    BsdfMemory memory;
    const Bsdf& bsdf = *memory.scatter(*layered("glass", "perfect"), shading_point());
    const MeanWeight mean = mean_weight(bsdf, at_angle(40, 1), Transport::Power, 400000, 9);
    EXPECT_NEAR(mean.mean.x, 1, 4.5f * mean.deviation.x);
}

}  // namespace
}  // namespace lxs::layered_test
