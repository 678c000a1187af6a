// The blender_* family: range, statistics and continuity; closed forms where there is no noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "shading_fixture.h"
#include "textures/cell_points.h"

namespace lxs::blender_texture_test {
namespace {

float at(const FloatTexture& texture, const Vec3& p) {
    TexturePoint point;
    point.p = p;
    return texture.evaluate(point);
}

struct Statistics {
    double mean = 0, variance = 0, largest_jump = 0;
};

Statistics statistics(const FloatTexture& texture) {
    constexpr int kPoints = 20000;
    constexpr float kStep = 1e-5f;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-8, 8);
    Statistics s;
    for (int i = 0; i < kPoints; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        const double value = at(texture, p);
        EXPECT_TRUE(value >= 0 && value <= 1) << p;
        s.mean += value / kPoints;
        s.variance += value * value / kPoints;
        s.largest_jump =
            std::max(s.largest_jump, std::abs(value - double(at(texture, p + Vec3(0, kStep, 0)))));
    }
    s.variance -= s.mean * s.mean;
    return s;
}

class BlenderTextureTest : public ::testing::Test {
  protected:
    ShadingFixture scene_;
};

TEST_F(BlenderTextureTest, EveryBasisIsContinuousNoiseAboutTheMiddle) {
    const std::map<std::string, double> means{
        {"blender_original", 0.5}, {"original_perlin", 0.5}, {"improved_perlin", 0.5},
        {"voronoi_f1", 0.554},     {"voronoi_f2", 0.72},     {"voronoi_f3", 0.84},
        {"voronoi_f4", 0.93},      {"voronoi_f2_f1", 0.25},  {"voronoi_crackle", 0.85}};
    for (const auto& [basis, mean] : means) {
        const auto texture = scene_.make_float(
            "blender_clouds", {text("noisebasis", basis), integer("noisedepth", 0)});
        const Statistics s = statistics(*texture);
        EXPECT_NEAR(s.mean, mean, 0.08) << basis;
        EXPECT_GT(s.variance, 0.001) << basis;
        EXPECT_LT(s.largest_jump, 0.02) << basis;
    }
}

// Points of density 1: their nearest one lies at the mean distance Gamma(4/3) (4 pi / 3)^(-1/3) =
// 0.554 if they are independent, and about as far if there is one in every cell.
TEST_F(BlenderTextureTest, NearestPointsAreAsFarAsTheirDensitySays) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> place(-100, 100);
    double mean = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto d = shading::nearest_points({place(random), place(random), place(random)},
                                               shading::DistanceMetric::Actual, 0);
        ASSERT_TRUE(std::is_sorted(d.begin(), d.end()));
        mean += d[0] / 20000;
    }
    EXPECT_NEAR(mean, 0.554, 0.05);
}

TEST_F(BlenderTextureTest, CellsAreUniformNumbers) {
    double mean = 0, variance = 0;
    for (int i = 0; i < 8000; ++i) {
        const int x = i % 20 - 10, y = i / 20 % 20 - 10, z = i / 400 - 10;
        const Vec3 corner(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        const double value = shading::cell_value(corner + Vec3(0.1f));
        EXPECT_EQ(value, shading::cell_value(corner + Vec3(0.9f)));
        mean += value / 8000;
        variance += value * value / 8000;
    }
    EXPECT_NEAR(mean, 0.5, 4 * std::sqrt(1 / 12.0 / 8000));
    EXPECT_NEAR(variance - mean * mean, 1 / 12.0, 0.005);
}

TEST_F(BlenderTextureTest, OctavesKeepTheMeanAndLessenTheVariance) {
    const auto clouds = [&](int depth, const char* type) {
        return statistics(*scene_.make_float(
            "blender_clouds", {integer("noisedepth", depth), text("noisetype", type)}));
    };
    const Statistics one = clouds(0, "soft_noise"), many = clouds(5, "soft_noise");
    EXPECT_NEAR(many.mean, 0.5, 0.02);
    // Weights 1, 1/2, 1/4, ... over their sum.
    EXPECT_NEAR(many.variance / one.variance, 4.0 / 3 / 3.88, 0.08);
    EXPECT_LT(clouds(0, "hard_noise").mean, 0.35);  // the mean of |noise|
}

TEST_F(BlenderTextureTest, NoiseSizeScalesThePattern) {
    const auto small = scene_.make_float("blender_clouds", {number("noisesize", 0.5)});
    const auto large = scene_.make_float("blender_clouds", {number("noisesize", 1)});
    EXPECT_FLOAT_EQ(at(*small, {0.3f, 0.2f, 0.7f}), at(*large, {0.6f, 0.4f, 1.4f}));
}

TEST_F(BlenderTextureTest, BrightAndContrastShiftAndSpread) {
    const auto blend =
        scene_.make_float("blender_blend", {number("bright", 1.25), number("contrast", 2)});
    EXPECT_FLOAT_EQ(at(*blend, {0, 0, 0}), 0.75f);
    EXPECT_FLOAT_EQ(at(*blend, {-0.25f, 0, 0}), 0.5f);
    EXPECT_FLOAT_EQ(at(*blend, {1, 0, 0}), 1);
}

TEST_F(BlenderTextureTest, BlendsAreGradients) {
    const auto blend = [&](const char* type, const Vec3& p, bool flip = false) {
        return at(*scene_.make_float("blender_blend", {text("type", type), flag("flipxy", flip)}),
                  p);
    };
    EXPECT_FLOAT_EQ(blend("lin", {0.5f, -1, 0}), 0.75f);
    EXPECT_FLOAT_EQ(blend("lin", {0.5f, -1, 0}, true), 0);
    EXPECT_FLOAT_EQ(blend("quad", {0, 0, 0}), 0.25f);
    EXPECT_FLOAT_EQ(blend("ease", {-0.5f, 0, 0}), 0.15625f);
    EXPECT_FLOAT_EQ(blend("diag", {1, 0, 0}), 0.75f);
    EXPECT_FLOAT_EQ(blend("sphere", {0, 0, 0.25f}), 0.75f);
    EXPECT_FLOAT_EQ(blend("halo", {0, 0.5f, 0}), 0.25f);
    EXPECT_FLOAT_EQ(blend("radial", {0, 1, 0}), 0.75f);
    EXPECT_THROW(blend("linear", Vec3(0.0f)), InputError);
}

TEST_F(BlenderTextureTest, WoodAndMarbleAreWaves) {
    const auto bands = scene_.make_float("blender_wood");
    EXPECT_NEAR(at(*bands, {0.1f, 0.2f, -0.1f}), 0.5 + 0.5 * std::sin(2.0), 1e-6);
    const auto rings =
        scene_.make_float("blender_wood", {text("type", "rings"), text("noisebasis2", "saw")});
    EXPECT_NEAR(at(*rings, {0, 0.1f, 0}), 2 / 6.2831853, 1e-6);
    const auto tri = scene_.make_float("blender_wood", {text("noisebasis2", "tri")});
    EXPECT_NEAR(at(*tri, {0.1f, 0, 0}), 2 / 6.2831853, 1e-6);
    const auto marble = [&](const char* type) {
        return at(
            *scene_.make_float("blender_marble", {text("type", type), number("turbulence", 0)}),
            {0.1f, 0.2f, -0.1f});
    };
    const double soft = 0.5 + 0.5 * std::sin(1.0);
    EXPECT_NEAR(marble("soft"), soft, 1e-6);
    EXPECT_NEAR(marble("sharp"), std::sqrt(soft), 1e-6);
    EXPECT_NEAR(marble("sharper"), std::pow(soft, 0.25), 1e-6);
}

TEST_F(BlenderTextureTest, AllOthersVaryWithinTheirRange) {
    const std::vector<std::pair<std::string, std::vector<ParameterValue>>> cases{
        {"blender_distortednoise", {}},
        {"blender_magic", {}},
        {"blender_magic", {integer("noisedepth", 5), number("turbulence", 1)}},
        {"blender_marble", {}},
        {"blender_wood", {text("type", "ringnoise")}},
        {"blender_stucci", {}},
        {"blender_stucci", {text("type", "wall_in")}},
        {"blender_stucci", {text("type", "wall_out")}},
        {"blender_voronoi", {text("distmetric", "manhattan")}},
        {"blender_voronoi", {text("distmetric", "minkovsky_half"), number("outscale", 0.3)}},
        {"blender_voronoi", {text("distmetric", "minkowsky"), number("minkowsky_exp", 3)}},
        {"blender_musgrave", {number("outscale", 0.3)}},
        {"blender_musgrave", {text("type", "ridged_multifractal"), number("outscale", 0.3)}},
        {"blender_musgrave", {text("type", "hybrid_multifractal"), number("outscale", 0.3)}},
        {"blender_musgrave", {text("type", "hetero_terrain"), number("outscale", 0.3)}},
        {"blender_musgrave", {text("type", "fBm")}}};
    for (const auto& [plugin, values] : cases) {
        const Statistics s = statistics(*scene_.make_float(plugin, values));
        EXPECT_GT(s.mean, 0.02) << plugin;
        EXPECT_LT(s.mean, 0.98) << plugin;
        EXPECT_GT(s.variance, 5e-4) << plugin;
        EXPECT_LT(s.largest_jump, 0.05) << plugin;
    }
}

TEST_F(BlenderTextureTest, WhiteNoiseIsUniformAndUncorrelated) {
    const auto noise = scene_.make_float("blender_noise");
    const Statistics s = statistics(*noise);
    EXPECT_NEAR(s.mean, 0.5, 0.01);
    EXPECT_NEAR(s.variance, 1 / 12.0, 0.003);
    EXPECT_GT(s.largest_jump, 0.9);
    EXPECT_EQ(at(*noise, {1, 2, 3}), at(*noise, {1, 2, 3}));
}

// The fractal of one octave is the noise; a whole second octave of weight 2^-h joins it.
TEST_F(BlenderTextureTest, MusgraveCountsPartsOfOctaves) {
    const auto fbm = [&](double octaves) {
        return at(
            *scene_.make_float("blender_musgrave", {text("type", "fBm"), number("octs", octaves)}),
            {0.17f, 0.33f, 0.05f});
    };
    EXPECT_NEAR(fbm(1.5), (fbm(1) + fbm(2)) / 2, 1e-6);
    EXPECT_GT(std::abs(fbm(2) - fbm(1)), 1e-3);
}

}  // namespace
}  // namespace lxs::blender_texture_test
