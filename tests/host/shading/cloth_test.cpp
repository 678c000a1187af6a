// Cloth all over its weave: fibres keep the light, highlights lie where yarns mirror it,
// parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bsdf_statistics.h"
#include "bsdfs/fibre_lobe.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"

namespace lxs::cloth_test {
namespace {

constexpr float kPi = 3.14159265f;

using shading::FibreLobe;

Vec3 direction(float cosine, float azimuth) {
    const float sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// Integral over all directions about the fibre, which lies along z.
double integral(const FibreLobe& lobe, const Vec3& a) {
    constexpr int kSines = 1000, kAzimuths = 200;
    double sum = 0;
    for (int i = 0; i < kSines; ++i) {
        const float sine = 2 * (static_cast<float>(i) + 0.5f) / kSines - 1;
        for (int j = 0; j < kAzimuths; ++j)
            sum += lobe.value({0, 0, 1}, a, direction(sine, 2 * kPi * (j + 0.5f) / kAzimuths));
    }
    return sum * 4 * kPi / (kSines * kAzimuths);
}

TEST(FibreLobe, ScattersAllItsLight) {
    for (const float variance : {0.004f, 0.06f, 0.5f}) {
        for (const float sine : {0.0f, 0.5f, -0.95f}) {
            EXPECT_NEAR(integral({variance, 0.3f}, direction(sine, 0.7f)), 1, 2e-3)
                << "variance " << variance << ", sine " << sine;
        }
    }
}

TEST(FibreLobe, PeaksOnTheConeThatAFibreMirrorsInto) {
    const FibreLobe lobe(0.005f, 0);
    const Vec3 a = direction(0.6f, 0);
    const float peak = lobe.value({0, 0, 1}, a, direction(-0.6f, 0.4f));
    for (const float sine : {0.6f, 0.0f, -0.4f, -0.8f})
        EXPECT_GT(peak, 4 * lobe.value({0, 0, 1}, a, direction(sine, 0.4f))) << sine;
    // The surface sends most of it back, cos(phi / 2).
    EXPECT_NEAR(lobe.value({0, 0, 1}, a, direction(-0.6f, 2)) / peak,
                std::cos(1.0f) / std::cos(0.2f), 1e-4f);
}

class ClothTest : public ::testing::Test {
  protected:
    std::shared_ptr<const Material> cloth(const std::string& preset, const Rgb& kd, const Rgb& ks,
                                          std::vector<ParameterValue> more = {}) {
        more.insert(more.end(), {text("presetname", preset), color("warp_Kd", kd),
                                 color("weft_Kd", kd), color("warp_Ks", ks), color("weft_Ks", ks)});
        return scene_.make_material("cloth", more);
    }
    static ShadingPoint at(const Vec2& uv = Vec2(0.0f)) {
        ShadingPoint point = shading_point();
        point.dpdv = Vec3(0, 1, 0);
        point.texture.uv = uv;
        return point;
    }

    ShadingFixture scene_;
    BsdfMemory memory_;
};

const char* const kPresets[] = {"denim",          "silk_charmeuse",         "cotton_twill",
                                "wool_gabardine", "polyester_lining_cloth", "silk_shantung"};

// Anywhere on the yarns, from anywhere: reciprocal to the bit, and no more light than arrives even
// if Kd and Ks are both white.
TEST_F(ClothTest, KeepsToPhysicsAllOverTheWeave) {
    UniformSource u(1);
    for (const char* preset : kPresets) {
        const auto material = cloth(preset, Rgb(1.0f), Rgb(1.0f));
        for (int i = 0; i < 40; ++i) {
            const Bsdf& bsdf = *memory_.scatter(*material, at(u.pair()));
            const Vec3 wo = direction(i % 4 == 0 ? 0.03f * u() : u(), 7 * u());
            EXPECT_LE(mean_weight(bsdf, wo, Transport::Power, 2000, i).mean.x, 1.001f);
            for (int k = 0; k < 200; ++k) {
                const Vec3 wi = direction(u(), 7 * u());
                ASSERT_EQ(bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes),
                          bsdf.evaluate(wi, wo, Transport::Power, kAllLobes));
            }
        }
    }
}

// The fibres alone: no sample's weight exceeds Ks, which is the proof that no mean does.
TEST_F(ClothTest, NoSampleOfTheFibresGainsLight) {
    UniformSource u(2);
    const auto material = cloth("silk_shantung", Rgb(0.0f), Rgb(1.0f));
    float largest = 0;
    for (int i = 0; i < 20000; ++i) {
        const Bsdf& bsdf = *memory_.scatter(*material, at(u.pair()));
        ASSERT_EQ(bsdf.lobes(), kGlossy);
        BsdfSample sample;
        const Vec2 pair = u.pair();
        if (!bsdf.sample(direction(u(), 7 * u()), pair, u(), Transport::Power, kAllLobes, sample))
            continue;
        largest = std::max(largest, sample.weight.x);
    }
    EXPECT_LE(largest, 1.0001f);
    EXPECT_GT(largest, 0.9f);
}

// What docs/reference/shading.md says, and what strategies are chosen by.
TEST_F(ClothTest, SpecularAlbedoIsAboutAQuarterOfKs) {
    UniformSource u(3);
    for (const char* preset : kPresets) {
        const auto material = cloth(preset, Rgb(0.0f), Rgb(0.8f));
        float straight = 0, guessed = 0;
        for (int i = 0; i < 400; ++i) {
            const Bsdf& bsdf = *memory_.scatter(*material, at(u.pair()));
            straight += mean_weight(bsdf, {0, 0, 1}, Transport::Power, 100, i).mean.x / 400;
            guessed += bsdf.albedo({0, 0, 1}, kAllLobes).x / 400;
        }
        EXPECT_GT(straight, 0.8f * 0.18f) << preset;
        EXPECT_LT(straight, 0.8f * 0.32f) << preset;
        EXPECT_NEAR(guessed, straight, 0.45f * straight) << preset;
    }
}

// Filaments without twist: seen and lit from above, a warp's highlight is in the middle of its bow;
// lit from where v grows, it moves up the bow to where the normal lies between.
TEST_F(ClothTest, HighlightsLieWhereTheBowMirrors) {
    const auto material = cloth("polyester_lining_cloth", Rgb(0.0f), Rgb(1.0f),
                                {number("repeat_u", 1), number("repeat_v", 1)});
    const auto brightest = [&](const ShadingPoint& frame, const Vec3& wi) {
        float best = -1, found = 0;
        for (int i = 1; i < 50; ++i) {
            ShadingPoint point = frame;
            point.texture.uv = Vec2(0.25f, 0.01f * i);  // up the warp in the lower left
            const float f = memory_.scatter(*material, point)
                                ->evaluate({0, 0, 1}, wi, Transport::Radiance, kGlossy)
                                .x;
            if (f > best) best = f, found = point.texture.uv.y;
        }
        return found;
    };
    // The inclination is asin(along sin umax), umax = 2 atan(2 crimp).
    const float sin_umax = std::sin(2 * std::atan(2 * 0.15f));
    const float expected = 0.25f + 0.25f * std::sin(0.2f) / sin_umax;
    const Vec3 wi(0, std::sin(0.4f), std::cos(0.4f));
    EXPECT_NEAR(brightest(at(), {0, 0, 1}), 0.25f, 0.011f);
    EXPECT_NEAR(brightest(at(), wi), expected, 0.03f);
    // A mirrored texture: v grows towards -y, and light from there is at its upper end again.
    ShadingPoint mirrored = at();
    mirrored.dpdv = Vec3(0, -1, 0);
    EXPECT_NEAR(brightest(mirrored, {wi.x, -wi.y, wi.z}), expected, 0.03f);
}

/// What a white lamp shows of a reflectance, cut at the gamut's border.
Rgb shown(const Rgb& written) {
    const Rgb seen = colour_of_reflectance(written);
    return {std::max(0.0f, seen.x), std::max(0.0f, seen.y), std::max(0.0f, seen.z)};
}

TEST_F(ClothTest, EachYarnHasItsColours) {
    const auto material = scene_.make_material(
        "cloth",
        {color("warp_Kd", Rgb(0.2f, 0, 0)), color("weft_Kd", Rgb(0, 0.4f, 0)),
         text("presetname", "silk_shantung"), number("repeat_u", 2), number("repeat_v", 2)});
    Rgb kd;
    ASSERT_TRUE(memory_.scatter(*material, at(Vec2(0.1f, 0.1f)))->lambertian(kd));
    EXPECT_EQ(kd, shown({0.2f, 0, 0}));
    ASSERT_TRUE(memory_.scatter(*material, at(Vec2(0.1f, 0.45f)))->lambertian(kd));
    EXPECT_EQ(kd, shown({0, 0.4f, 0}));
    EXPECT_EQ(material->facts().lobes, kDiffuse);
    EXPECT_FALSE(material->facts().reads_dpdv);
    EXPECT_TRUE(cloth("denim", Rgb(0.5f), Rgb(0.1f))->facts().reads_dpdv);
}

TEST_F(ClothTest, MixturesHandOnWhatItNeeds) {
    scene_.materials["cloth"] = cloth("denim", Rgb(0.5f), Rgb(0.1f));
    scene_.materials["matte"] = scene_.make_material("matte");
    const std::vector<ParameterValue> parts{text("namedmaterial1", "matte"),
                                            text("namedmaterial2", "cloth")};
    EXPECT_TRUE(scene_.make_material("mix", parts)->facts().reads_dpdv);
    EXPECT_TRUE(scene_.make_material("layered", parts)->facts().reads_dpdv);
    EXPECT_TRUE(scene_
                    .make_material("doubleside", {text("frontnamedmaterial", "matte"),
                                                  text("backnamedmaterial", "cloth")})
                    ->facts()
                    .reads_dpdv);
}

TEST_F(ClothTest, PlainMaterialsNeedNoCoordinatesUnderNothingThatDoes) {
    scene_.materials["matte"] = scene_.make_material("matte");
    EXPECT_FALSE(scene_.materials["matte"]->facts().reads_uv);
    EXPECT_FALSE(scene_.make_material("glass")->facts().reads_uv);
    EXPECT_FALSE(scene_.make_material("mirror")->facts().reads_uv);
    EXPECT_TRUE(cloth("denim", Rgb(0.5f), Rgb(0.1f))->facts().reads_uv);
    EXPECT_TRUE(
        scene_.make_material("glossycoating", {text("basematerial", "matte")})->facts().reads_uv);
}

TEST_F(ClothTest, WithoutColoursIsBlack) {
    const auto material = scene_.make_material("cloth");
    EXPECT_EQ(memory_.scatter(*material, at(Vec2(0.3f, 0.3f))), nullptr);
    EXPECT_EQ(material->facts().lobes, 0);
}

TEST_F(ClothTest, PresetsSayThatTheirFibresAreStandIns) {
    scene_.make_material("cloth");
    scene_.make_material("cloth", {text("presetname", "wool_garbardine")});
    const std::vector<std::string> expected{
        "the measured constants of the fibres of cloth \"denim\" are not available; its weave, a "
        "3/1 twill, has fibres of our choice",
        "the measured constants of the fibres of cloth \"wool_gabardine\" are not available; its "
        "weave, a 2/1 twill, has fibres of our choice"};
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
    EXPECT_EQ(scene_.diagnostics.lines[1], 7u);
}

TEST_F(ClothTest, AnUnknownPresetIsRenderedAsDenim) {
    EXPECT_THROW(scene_.make_material("cloth", {text("presetname", "tweed")}), InputError);
    scene_.diagnostics.lenient = true;
    EXPECT_NE(scene_.make_material("cloth", {text("presetname", "tweed")}), nullptr);
    const std::vector<std::string> expected{
        "unknown cloth \"tweed\"; known: denim, silk_charmeuse, cotton_twill, wool_gabardine, "
        "polyester_lining_cloth, silk_shantung; \"denim\" is used instead"};
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
    EXPECT_EQ(scene_.diagnostics.lines[0], 7u);
}

}  // namespace
}  // namespace lxs::cloth_test
