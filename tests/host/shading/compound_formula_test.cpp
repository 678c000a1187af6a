// What is made of other materials, and what lets light through: closed forms at ten settings each.
#include "lux_formulas.h"

namespace lxs::lux::compound_formula_test {
namespace {

constexpr int kSettings = 10;
constexpr float kBelowOne = 0x1.fffffep-1f;

/// Ten directions to the front, from the normal to grazing.
Vec3 outgoing(int i) {
    return Pair::direction(8 * i + 5, 35 * i);
}

void add_matte(ShadingFixture& scene, const std::string& name, double kd) {
    scene.materials[name] = scene.make_material("matte", {color("Kd", grey(kd))});
}

TEST(CompoundFormula, Mix) {
    ShadingFixture scene;
    for (int i = 0; i < kSettings; ++i) {
        const double amount = i / 9.0, a = 0.9 - 0.05 * i, b = 0.1 + 0.06 * i;
        add_matte(scene, "a", a);
        add_matte(scene, "b", b);
        const auto mix = scene.make_material(
            "mix",
            {text("namedmaterial1", "a"), text("namedmaterial2", "b"), number("amount", amount)});
        expect_formula(*mix, 1e-5, [&](const Vec3&, const Vec3&) {
            return ((1 - amount) * a + amount * b) / kPi;
        });
    }
}

TEST(CompoundFormula, DoubleSide) {
    ShadingFixture scene;
    for (int i = 0; i < kSettings; ++i) {
        const double front = 0.05 + 0.09 * i, back = 0.95 - 0.08 * i;
        add_matte(scene, "front", front);
        add_matte(scene, "back", back);
        const auto sheet = scene.make_material(
            "doubleside", {text("frontnamedmaterial", "front"), text("backnamedmaterial", "back")});
        expect_formula(*sheet, 1e-5, [&](const Vec3&, const Vec3&) { return front / kPi; });
        expect_formula(
            *sheet, 1e-5, [&](const Vec3&, const Vec3&) { return back / kPi; }, 1, kBelow, kBelow);
        expect_formula(
            *sheet, 1e-5, [&](const Vec3&, const Vec3&) { return 0.0; }, 1, Vec3(1.0f), kBelow);
    }
}

TEST(CompoundFormula, Null) {
    ShadingFixture scene;
    BsdfMemory memory;
    const auto material = scene.make_material("null");
    for (int i = 0; i < kSettings; ++i) {
        for (const Vec3& wo : {outgoing(i), outgoing(i) * kBelow}) {
            BsdfSample sample;
            ASSERT_TRUE(memory.scatter(*material, shading_point())
                            ->sample(wo, {0.3f, 0.7f}, 0.1f * static_cast<float>(i),
                                     Transport::Radiance, kAllLobes, sample));
            EXPECT_EQ(sample.wi, -wo);
            EXPECT_EQ(sample.weight, Rgb(1.0f));
            EXPECT_TRUE(sample.straight);
        }
    }
}

/// Transmission from the front of a surface of relative index `n`: direction by Snell's law, mean
/// weight kt (1 - F), for radiance over n^2.
void expect_transmission(const Bsdf& bsdf, const Vec3& wo, double n, double kt) {
    const double passed = kt * (1 - dielectric(wo.z, n));
    for (const Transport transport : {Transport::Power, Transport::Radiance}) {
        BsdfSample sample;
        ASSERT_TRUE(bsdf.sample(wo, {0.5f, 0.5f}, kBelowOne, transport, kAllLobes, sample));
        ASSERT_TRUE(sample.transmitted);
        EXPECT_NEAR(sample.wi.x, -wo.x / n, 1e-5);
        EXPECT_NEAR(sample.wi.y, -wo.y / n, 1e-5);
        const double scale = transport == Transport::Radiance ? 1 / (n * n) : 1;
        EXPECT_NEAR(sample.weight.x, passed * scale, 1e-4) << n << ' ' << wo.z;
    }
}

TEST(CompoundFormula, GlassTransmission) {
    ShadingFixture scene;
    BsdfMemory memory;
    for (int i = 0; i < kSettings; ++i) {
        const double n = 1.1 + 0.15 * i, kt = 1 - 0.08 * i;
        const auto glass = scene.make_material(
            "glass", {number("index", n), color("Kt", grey(kt)), color("Kr", Rgb(0.0f))});
        expect_transmission(*memory.scatter(*glass, shading_point()), outgoing(i), n, kt);
    }
}

TEST(CompoundFormula, Glass2BetweenMedia) {
    ShadingFixture scene;
    BsdfMemory memory;
    const auto glass = scene.make_material("glass2");
    for (int i = 0; i < kSettings; ++i) {
        const double inside = 1.2 + 0.15 * i, outside = 1 + 0.07 * i, n = inside / outside;
        const Medium interior(Rgb(0.0f), static_cast<float>(inside));
        const Medium exterior(Rgb(0.0f), static_cast<float>(outside));
        ShadingPoint point = shading_point();
        point.interior = &interior;
        point.exterior = &exterior;
        const Bsdf& bsdf = *memory.scatter(*glass, point);
        const Vec3 wo = outgoing(i);
        BsdfSample sample;
        ASSERT_TRUE(bsdf.sample(wo, {0.5f, 0.5f}, kBelowOne, Transport::Power, kAllLobes, sample));
        ASSERT_TRUE(sample.transmitted);
        EXPECT_NEAR(sample.wi.x, -wo.x / n, 1e-5);
        // Nothing is absorbed: the weight is one, and reflection has Fresnel's share of choices.
        const MeanWeight mean = mean_weight(bsdf, wo, Transport::Power, 20000, 7);
        EXPECT_NEAR(mean.mean.x, 1, 1e-4);
        int reflected = 0;
        constexpr int kChoices = 4000;
        for (int k = 0; k < kChoices; ++k) {
            const float u = (static_cast<float>(k) + 0.5f) / kChoices;
            ASSERT_TRUE(bsdf.sample(wo, {0.5f, 0.5f}, u, Transport::Power, kAllLobes, sample));
            reflected += sample.transmitted ? 0 : 1;
        }
        EXPECT_NEAR(reflected / double(kChoices), dielectric(wo.z, n), 1e-3);
    }
}

// The colour of a smooth aluminium at normal incidence and at 53 degrees, between which the pairs'
// half angles lie (SurfaceFormula.MetalPresets).
TEST(CompoundFormula, MetalRoughness) {
    ShadingFixture scene;
    BsdfMemory memory;
    for (int i = 0; i < kSettings; ++i) {
        const double roughness = 0.04 + 0.06 * i;
        const Facets facets{roughness, roughness};
        const auto metal = scene.make_material(
            "metal", {text("name", "aluminium"), number("uroughness", roughness),
                      number("vroughness", roughness)});
        const Bsdf& bsdf = *memory.scatter(*metal, shading_point());
        for (const Pair& pair : pairs()) {
            const Half h(pair.wo(), pair.wi());
            const Rgb f = bsdf.evaluate(pair.wo(), pair.wi(), Transport::Radiance, kAllLobes);
            const double reflectance = f.y / facets.reflection(h);
            EXPECT_GT(reflectance, 0.9142 - 0.009) << roughness;
            EXPECT_LT(reflectance, 0.9215 + 0.009) << roughness;
        }
    }
}

// A layer with gaps of transparency 1 - opacity over another: light goes to and fro between them.
TEST(CompoundFormula, LayeredMattes) {
    ShadingFixture scene;
    BsdfMemory memory;
    for (int i = 0; i < kSettings; ++i) {
        const double upper = 0.1 + 0.08 * i, lower = 0.9 - 0.07 * i, opacity = 0.1 + 0.08 * i;
        add_matte(scene, "upper", upper);
        add_matte(scene, "lower", lower);
        const auto layered = scene.make_material(
            "layered", {text("namedmaterial1", "upper"), text("namedmaterial2", "lower"),
                        number("opacity1", opacity)});
        const double open = 1 - opacity;
        const double expected =
            opacity * upper + open * open * lower / (1 - opacity * upper * lower);
        const MeanWeight mean = mean_weight(*memory.scatter(*layered, shading_point()), outgoing(i),
                                            Transport::Power, 60000, 11);
        EXPECT_NEAR(mean.mean.x, expected, 4.5 * mean.deviation.x + 1e-6) << i;
    }
}

}  // namespace
}  // namespace lxs::lux::compound_formula_test
