// Every material's Bsdf: sampling, density and value agree; reciprocity; no gain of energy;
// finite, non-negative results for any input; memory as announced.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bsdf_statistics.h"
#include "bsdfs/directions.h"
#include "shading_fixture.h"

namespace lxs::bsdf_test {
namespace {

struct Case {
    const char* name;
    std::vector<ParameterValue> values;
    const char* plugin;
    /// The model itself sends back more than arrives at grazing angles: LuxRender's density of
    /// facets with a strong grain does.
    bool gains = false;
    bool by_wavelengths = false;  ///< as a pass of a spectral render sees it
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

std::vector<ParameterValue> roughness(double u, double v) {
    return {number("uroughness", u), number("vroughness", v)};
}
std::vector<ParameterValue> with(std::vector<ParameterValue> a,
                                 const std::vector<ParameterValue>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const ParameterValue kSmith = text("distribution", "ggx");
const Rgb kWhite(1.0f), kTinted(0.7f, 0.4f, 0.1f), kDull(0.05f, 0.06f, 0.07f);

std::vector<Case> cases() {
    return {
        {"matte", {color("Kd", kTinted)}, "matte"},
        {"matte_white", {color("Kd", kWhite)}, "matte"},
        {"matte_sigma", {color("Kd", kWhite), number("sigma", 30)}, "matte"},
        {"matte_sigma90", {color("Kd", kWhite), number("sigma", 90)}, "matte"},
        {"mattetranslucent",
         {color("Kr", Rgb(0.3f)), color("Kt", {0.5f, 0.6f, 0.2f})},
         "mattetranslucent"},
        {"mattetranslucent_sigma",
         {color("Kr", kTinted), number("sigma", 35), flag("energyconserving", true)},
         "mattetranslucent"},
        {"mirror", {}, "mirror"},
        {"glass", {}, "glass"},
        {"glass_tinted", {color("Kt", kTinted), number("index", 2.4)}, "glass"},
        {"glass_architectural", {flag("architectural", true)}, "glass"},
        {"glass_pane", {flag("architectural", true), flag("pane", true)}, "glass"},
        {"roughglass", roughness(0.5, 0.5), "roughglass"},
        {"roughglass_tinted",
         with(roughness(0.3, 0.6), {color("Kt", kTinted), number("index", 2.4)}), "roughglass"},
        {"roughglass_bubble", with(roughness(0.8, 0.8), {number("index", 0.7)}), "roughglass"},
        {"roughglass_dispersing",
         with(roughness(0.3, 0.3),
              {color("Kt", kTinted), number("cauchyb", 0.04), flag("dispersion", true)}),
         "roughglass", false, true},
        {"metal", roughness(0.15, 0.15), "metal"},
        {"metal_gold_rough", with(roughness(0.8, 0.8), {text("name", "gold")}), "metal"},
        {"metal_grain", roughness(0.1, 0.35), "metal"},
        {"metal_grain_v", roughness(0.5, 0.2), "metal"},
        {"metal2_dielectric", roughness(0.3, 0.3), "metal2"},
        {"metal2_ideal", with(roughness(0.4, 0.4), {number("fresnel", 4e3)}), "metal2"},
        {"metal2_ideal_smooth", with(roughness(0.12, 0.12), {number("fresnel", 4e3)}), "metal2"},
        {"metal2_ideal_grain", with(roughness(0.2, 0.5), {number("fresnel", 4e3)}), "metal2", true},
        {"metal2_smith", with(roughness(0.4, 0.4), {number("fresnel", 4e3), kSmith}), "metal2"},
        {"metal2_smith_grain", with(roughness(0.1, 0.5), {number("fresnel", 4e3), kSmith}),
         "metal2"},
        {"roughglass_smith", with(roughness(0.3, 0.6), {kSmith}), "roughglass"},
        {"roughglass_smith_bubble", with(roughness(0.8, 0.8), {number("index", 0.7), kSmith}),
         "roughglass"},
        {"coateddiffuse", with(roughness(0.3, 0.3), {color("Kd", kTinted)}), "coateddiffuse"},
        {"coateddiffuse_white",
         with(roughness(0.2, 0.6),
              {color("Kd", kWhite), number("thickness", 0), integer("maxdepth", 1000)}),
         "coateddiffuse"},
        {"coateddiffuse_black", with(roughness(0.5, 0.5), {color("Kd", Rgb(0.0f))}),
         "coateddiffuse"},
        {"shinymetal_full", roughness(0.2, 0.2), "shinymetal"},
        {"shinymetal", with(roughness(0.25, 0.25), {color("Kr", Rgb(0.3f)), color("Ks", kTinted)}),
         "shinymetal"},
        {"glossy", with(roughness(0.2, 0.2), {color("Kd", kTinted), color("Ks", kDull)}), "glossy"},
        {"glossy_white", with(roughness(0.15, 0.15), {color("Kd", kWhite), color("Ks", kDull)}),
         "glossy"},
        {"glossy_white_rough", with(roughness(1, 1), {color("Kd", kWhite), number("index", 1.5)}),
         "glossy"},
        {"glossy_multibounce",
         with(roughness(0.6, 0.6),
              {color("Kd", kWhite), color("Ks", Rgb(0.3f)), flag("multibounce", true)}),
         "glossy"},
        {"glossy_full_multibounce", with(roughness(0.7, 0.7), {flag("multibounce", true)}),
         "glossy"},
        {"glossy_absorbing",
         with(roughness(0.2, 0.3),
              {color("Kd", kWhite), color("Ks", kDull), color("Ka", kTinted), number("d", 0.3)}),
         "glossy"},
        {"glossy_rough_base",
         with(roughness(0.2, 0.4), {color("Kd", kWhite), color("Ks", kDull), number("sigma", 40)}),
         "glossy"},
        {"glossy_not_separable",
         with(roughness(0.1, 0.1), {color("Kd", kTinted), color("Ks", kDull), color("Ka", kTinted),
                                    number("d", 0.2), flag("separable", false)}),
         "glossy"},
        {"glossy_conserving",
         with(roughness(0.3, 0.3), {color("Kd", kTinted), color("Ks", kDull),
                                    flag("conserving", true), text("fresnel", "dielectric")}),
         "glossy"},
        {"glossy_conserving_metal",
         with(roughness(0.7, 0.7),
              {color("Kd", Rgb(0.0f)), color("Ks", kTinted), flag("conserving", true)}),
         "glossy"},
        {"glossy_conserving_grain",
         with(roughness(0.1, 0.5),
              {color("Kd", kTinted), color("Ks", kDull), flag("conserving", true)}),
         "glossy"},
        {"glossy_black_base", with(roughness(0.2, 0.2), {color("Kd", Rgb(0.0f))}), "glossy"},
        {"glossytranslucent",
         with(roughness(0.3, 0.3), {color("Kd", {0.3f, 0.4f, 0.2f}),
                                    color("Kt", {0.4f, 0.6f, 0.8f}), color("Ks", kDull)}),
         "glossytranslucent"},
        {"glossytranslucent_twosided",
         with(roughness(0.2, 0.4),
              {color("Kd", Rgb(0.5f)), color("Kt", Rgb(0.5f)), number("index", 1.5),
               color("Ka", kTinted), number("d", 0.2), flag("onesided", false),
               color("backface_Ks", kTinted), number("backface_uroughness", 0.7),
               number("backface_vroughness", 0.7)}),
         "glossytranslucent"},
        {"carpaint_white", {text("name", "white")}, "carpaint", true},
        {"carpaint",
         {color("Kd", {0.2f, 0.1f, 0.3f}), color("Ks1", Rgb(0.3f)), color("Ks2", kTinted * 0.4f),
          color("Ks3", Rgb(0.1f)), number("R1", 0.6), number("R2", 0.1), number("R3", 0.9),
          number("M1", 0.6), number("M2", 0.3), number("M3", 0.25), color("Ka", kTinted),
          number("d", 0.3)},
         "carpaint"},
        {"cloth_denim",
         {color("warp_Kd", {0.1f, 0.15f, 0.4f}), color("weft_Kd", kWhite), color("warp_Ks", kDull),
          color("weft_Ks", kTinted), number("repeat_u", 1), number("repeat_v", 1)},
         "cloth"},
        {"cloth_charmeuse",
         {text("presetname", "silk_charmeuse"), color("warp_Kd", kDull), color("warp_Ks", kWhite),
          color("weft_Ks", kWhite), number("repeat_u", 1.3), number("repeat_v", -0.9)},
         "cloth"},
        {"cloth_gabardine_fibres",
         {text("presetname", "wool_gabardine"), color("warp_Ks", kTinted), color("weft_Ks", kWhite),
          number("repeat_u", 1.7), number("repeat_v", 1.3)},
         "cloth"},
        {"doubleside",
         {text("frontnamedmaterial", "metal"), text("backnamedmaterial", "glossy")},
         "doubleside",
         true},
        {"doubleside_translucent",
         {text("frontnamedmaterial", "translucent"), text("backnamedmaterial", "matte")},
         "doubleside",
         true},
        {"scatter", {color("Kd", kWhite), color("g", {0.5f, 0.0f, -0.3f})}, "scatter", true},
        {"velvet", {color("Kd", kTinted)}, "velvet", true},
        {"velvet_other",
         {color("Kd", Rgb(0.5f)), number("p1", 1), number("p2", 3), number("p3", -1.5),
          number("thickness", 0.4)},
         "velvet",
         true},
        {"glossycoating_metal",
         with(roughness(0.3, 0.2), {text("basematerial", "metal"), color("Ks", kDull)}),
         "glossycoating"},
        {"glossycoating_mirror",
         with(roughness(0.2, 0.2), {text("basematerial", "mirror"), number("index", 1.5)}),
         "glossycoating"},
        {"glossycoating_twice",
         with(roughness(0.5, 0.5),
              {text("basematerial", "glossy"), color("Ks", kDull), color("Ka", kTinted),
               number("d", 0.2), flag("multibounce", true)}),
         "glossycoating"},
        {"glossy_lossy", with(roughness(0.2, 0.4), {color("Kd", kWhite), color("Ks", kDull)}),
         "glossy_lossy"},
        {"glossy_lossy_white", roughness(0.3, 0.3), "glossy_lossy"},
        {"null", {}, "null"},
        {"mix_two_lobes",
         {text("namedmaterial1", "metal"), text("namedmaterial2", "matte"), number("amount", 0.3)},
         "mix"},
        {"mix_specular",
         {text("namedmaterial1", "mirror"), text("namedmaterial2", "glossy"),
          number("amount", 0.6)},
         "mix",
         true},
        {"mix_null", {text("namedmaterial1", "null"), text("namedmaterial2", "matte")}, "mix"}};
}

class BsdfTest : public ::testing::TestWithParam<Case> {
  protected:
    BsdfTest() {
        scene_.materials["metal"] = scene_.make_material("metal", roughness(0.2, 0.2));
        scene_.materials["matte"] = scene_.make_material("matte", {color("Kd", kTinted)});
        scene_.materials["translucent"] =
            scene_.make_material("mattetranslucent", {color("Kr", kDull), color("Kt", kTinted)});
        scene_.materials["mirror"] = scene_.make_material("mirror");
        scene_.materials["null"] = scene_.make_material("null");
        scene_.materials["glossy"] =
            scene_.make_material("glossy", {color("Ks", kDull), number("uroughness", 0.3)});
        material_ = scene_.make_material(GetParam().plugin, GetParam().values);
    }
    const Bsdf& at(const ShadingPoint& point) {
        ShadingPoint seen = point;
        if (GetParam().by_wavelengths) seen.texture.wavelengths = &wavelengths_;
        const Bsdf* bsdf = memory_.scatter(*material_, seen);
        EXPECT_NE(bsdf, nullptr);
        return *bsdf;
    }

    ShadingFixture scene_;
    const Wavelengths wavelengths_ = wavelengths_of_pass(0, 3);
    BsdfMemory memory_;
    std::shared_ptr<const Material> material_;
};

/// A point with a bent shading normal and a grain that isn't perpendicular to it, amidst a yarn.
ShadingPoint bent_point() {
    ShadingPoint point =
        shading_point({0.3f, -0.5f, 0.8f}, {0.42f, -0.4f, 0.8f}, {0.7f, 0.4f, 0.2f});
    point.texture.uv = Vec2(0.37f, 0.62f);
    return point;
}

Vec3 tilted(const Vec3& n, float degrees, float azimuth) {
    const float theta = degrees * kPi / 180;
    return Frame(n).to_world({std::sin(theta) * std::cos(azimuth),
                              std::sin(theta) * std::sin(azimuth), std::cos(theta)});
}

// 29 cases with 9 tests each: Sidak-corrected to 0.2 % for all of them together.
constexpr double kSignificance = 1e-5;

TEST_P(BsdfTest, SamplesFollowTheDensity) {
    const ShadingPoint point = bent_point();
    const Bsdf& bsdf = at(point);
    std::uint32_t seed = 1;
    for (const float degrees : {5.0f, 50.0f, 78.0f, 130.0f}) {
        const Vec3 wo = tilted(point.ns, degrees, 0.7f * degrees);
        for (const LobeMask mask : {kAllLobes, LobeMask(kDiffuse | kGlossy)}) {
            if (!(bsdf.lobes() & mask & (kDiffuse | kGlossy))) continue;
            EXPECT_GT(chi_square_p_value(bsdf, wo, point.ng, mask, ++seed), kSignificance)
                << "wo at " << degrees << " degrees, lobes " << int{mask};
        }
    }
}

TEST_P(BsdfTest, EachLobeAloneFollowsItsDensity) {
    const ShadingPoint point = bent_point();
    const Bsdf& bsdf = at(point);
    if (!(bsdf.lobes() & kDiffuse) || !(bsdf.lobes() & kGlossy)) return;
    for (const LobeMask mask : {kDiffuse, kGlossy}) {
        const Vec3 wo = tilted(point.ns, 40, 1);
        EXPECT_GT(chi_square_p_value(bsdf, wo, point.ng, mask, mask), kSignificance);
    }
}

TEST_P(BsdfTest, WeightIsValueTimesCosineOverDensity) {
    const ShadingPoint point = bent_point();
    const Bsdf& bsdf = at(point);
    UniformSource u(3);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 wo = u.direction();
        const auto mask = static_cast<LobeMask>(i % 8);
        BsdfSample sample;
        const Vec2 uv = u.pair();
        if (!bsdf.sample(wo, uv, u(), Transport::Radiance, mask, sample)) continue;
        ASSERT_TRUE(sample.lobe & mask & bsdf.lobes());
        ASSERT_NEAR(sample.wi.length(), 1, 1e-5);
        ASSERT_EQ(sample.transmitted, wo.dot(point.ng) * sample.wi.dot(point.ng) < 0);
        if (sample.lobe == kSpecular) {
            ASSERT_EQ(sample.pdf, 0);
            continue;
        }
        const Rgb f = bsdf.evaluate(wo, sample.wi, Transport::Radiance, mask);
        const float pdf = bsdf.pdf(wo, sample.wi, mask);
        ASSERT_NEAR(sample.pdf, pdf, 2e-3f * pdf);
        for (int c = 0; c < 3; ++c) {
            const float weight = f[c] * std::abs(sample.wi.dot(point.ns)) / pdf;
            ASSERT_NEAR(sample.weight[c], weight, 2e-3f * weight + 1e-6f);
        }
    }
}

/// Where two specular lobes are to choose from, u_lobe is below what is said for the one and not
/// for the other, each is drawn alike all over its part, and where there is no choice none is said.
TEST_P(BsdfTest, SaysWhereTheSecondSpecularLobeBegins) {
    const Bsdf& bsdf = at(bent_point());
    UniformSource u(11);
    for (int i = 0; i < 200; ++i) {
        const Vec3 wo = u.direction();
        const float first = bsdf.first_specular(wo);
        ASSERT_GE(first, 0);
        ASSERT_LE(first, 1);
        if (!(first > 0 && first < 1)) continue;
        ASSERT_EQ(bsdf.lobes(), kSpecular);
        const auto draw = [&](float u_lobe, BsdfSample& sample) {
            return bsdf.sample(wo, {0, 0}, u_lobe, Transport::Radiance, kSpecular, sample);
        };
        BsdfSample begin, end, second;
        const float below = std::nextafter(first, 0.0f);
        ASSERT_EQ(draw(0, begin), draw(below, end));
        EXPECT_EQ(begin.wi, end.wi);
        if (draw(0, begin) && draw(first, second)) {
            EXPECT_NE(begin.wi, second.wi);
        }
    }
}

TEST_P(BsdfTest, IsReciprocal) {
    const ShadingPoint point = bent_point();
    const Bsdf& bsdf = at(point);
    UniformSource u(4);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 a = u.direction(), b = u.direction();
        const Rgb forth = bsdf.evaluate(a, b, Transport::Radiance, kAllLobes);
        const Rgb back = bsdf.evaluate(b, a, Transport::Power, kAllLobes);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(forth[c], back[c], 1e-4f * forth[c] + 1e-6f);
    }
}

TEST_P(BsdfTest, NeverReflectsMoreThanArrives) {
    if (GetParam().gains) return;
    const ShadingPoint point = shading_point({0, 0, 1}, {0, 0, 1}, {1, 0.3f, 0});
    const Bsdf& bsdf = at(point);
    // What the tabulated albedos of coatings can be wrong by.
    constexpr float kTableError = 4e-3f;
    for (const float degrees : {1.0f, 30.0f, 60.0f, 75.0f, 85.0f, 88.0f, 89.5f, 100.0f, 170.0f}) {
        for (const float azimuth : {0.3f, 1.9f}) {
            const Vec3 wo = tilted(point.ns, degrees, azimuth);
            const MeanWeight mean = mean_weight(bsdf, wo, Transport::Power, 20000, 5);
            for (int c = 0; c < 3; ++c) {
                EXPECT_LE(mean.mean[c], 1 + 5 * mean.deviation[c] + kTableError)
                    << degrees << " degrees";
            }
            const Rgb albedo = bsdf.albedo(wo, kAllLobes);
            EXPECT_LE(max_component(albedo), 1.0001f);
        }
    }
}

TEST_P(BsdfTest, MeanWeightIsTheIntegral) {
    const ShadingPoint point = bent_point();
    const Bsdf& bsdf = at(point);
    if (bsdf.lobes() & kSpecular) return;  // the integral does not see deltas
    const Vec3 wo = tilted(point.ns, 35, 2);
    const MeanWeight mean = mean_weight(bsdf, wo, Transport::Radiance, 100000, 6);
    const Rgb integral = integrated_albedo(bsdf, wo, point.ns);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(mean.mean[c], integral[c], 5 * mean.deviation[c] + 3e-3f);
}

TEST_P(BsdfTest, AnyInputGivesFiniteResults) {
    UniformSource u(8);
    const auto check = [](const Rgb& value) {
        ASSERT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z));
        ASSERT_TRUE(value.x >= 0 && value.y >= 0 && value.z >= 0);
    };
    for (int i = 0; i < 20000; ++i) {
        const Vec3 ng = i % 5 == 0 ? Vec3(0, 0, 1) : u.direction();
        Vec3 ns = i % 3 == 0 ? ng : (ng + u.direction() * 0.99f).normalized();
        if (ns.dot(ng) <= 0) ns = ng;
        const Vec3 dpdu = i % 7 == 0 ? Vec3(0.0f) : i % 7 == 1 ? ns : u.direction();
        const Bsdf& bsdf = at(shading_point(ng, ns, dpdu));
        Vec3 wo = u.direction(), wi = u.direction();
        const Vec3 tangent = Frame(i % 2 ? ns : ng).s;
        if (i % 4 == 1) wo = tangent;
        if (i % 4 == 2) wo = (tangent + ns * 1e-7f).normalized();
        if (i % 11 == 0) wi = wo;
        if (i % 11 == 1) wi = -wo;
        if (i % 11 == 2) wi = shading::reflect(wo, ns);
        const auto mask = static_cast<LobeMask>(i % 8);
        check(bsdf.evaluate(wo, wi, Transport::Radiance, mask));
        check(bsdf.albedo(wo, mask));
        const float pdf = bsdf.pdf(wo, wi, mask);
        ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0);
        const float edges[] = {0.0f, 0x1.fffffep-1f, u()};
        BsdfSample sample;
        if (!bsdf.sample(wo, {edges[i % 3], edges[i / 3 % 3]}, edges[i / 9 % 3], Transport::Power,
                         mask, sample))
            continue;
        check(sample.weight);
        ASSERT_TRUE(std::isfinite(sample.pdf) && sample.pdf >= 0);
        ASSERT_NEAR(sample.wi.length(), 1, 1e-4);
    }
}

TEST_P(BsdfTest, TakesNoMoreMemoryThanAnnounced) {
    std::array<std::byte, 4096> buffer;
    const std::size_t announced = material_->facts().max_bsdf_bytes;
    ASSERT_LE(announced, buffer.size() - 1);
    std::pmr::monotonic_buffer_resource memory(buffer.data() + 1, announced,
                                               std::pmr::null_memory_resource());
    const Bsdf* bsdf = material_->scatter(bent_point(), memory);
    ASSERT_NE(bsdf, nullptr);
    EXPECT_EQ(bsdf->lobes() & ~material_->facts().lobes, 0);
}

INSTANTIATE_TEST_SUITE_P(Materials, BsdfTest, ::testing::ValuesIn(cases()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace lxs::bsdf_test
