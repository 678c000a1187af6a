// Textures of Perlin noise: known values, and statistics.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "shading_fixture.h"
#include "textures/perlin_noise.h"

namespace lxs::noise_texture_test {
namespace {

using shading::perlin_noise;

struct Statistics {
    double mean = 0, variance = 0, least = 1e30, most = -1e30;
};

template <class Function>
Statistics statistics(Function function, int points = 40000) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-120, 120);
    Statistics s;
    for (int i = 0; i < points; ++i) {
        const double value = function(Vec3(place(random), place(random), place(random)));
        s.mean += value / points;
        s.variance += value * value / points;
        s.least = std::min(s.least, value);
        s.most = std::max(s.most, value);
    }
    s.variance -= s.mean * s.mean;
    return s;
}

TEST(PerlinNoise, IsZeroOnTheLatticeAndRepeatsEvery256) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> whole(-300, 300);
    for (int i = 0; i < 200; ++i) {
        const auto number = [&] { return static_cast<float>(whole(random)); };
        const Vec3 p(number(), number(), number());
        EXPECT_EQ(perlin_noise(p), 0);
        const Vec3 within = p + Vec3(0.25f, 0.5f, 0.125f);
        EXPECT_EQ(perlin_noise(within), perlin_noise(within + Vec3(256, -256, 512)));
    }
}

// Beside a lattice point the noise is its gradient: one of twelve, all of squared length 2.
TEST(PerlinNoise, GradientsPointToTheMiddlesOfACubesEdges) {
    constexpr float kStep = 1.0f / 1024;
    std::array<int, 3> zeros{};
    for (int i = 0; i < 256; ++i) {
        const int x = i % 8, y = i / 8 % 8, z = i / 64;
        const Vec3 p(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step(0.0f);
            step[axis] = kStep;
            gradient[axis] = (perlin_noise(p + step) - perlin_noise(p - step)) / (2 * kStep);
            zeros[static_cast<std::size_t>(axis)] += std::abs(gradient[axis]) < 0.01f ? 1 : 0;
        }
        EXPECT_NEAR(gradient.length2(), 2, 0.02) << p;
    }
    for (const int count : zeros)
        EXPECT_NEAR(count, 85, 30);
}

TEST(PerlinNoise, IsContinuousAndHasMeanZero) {
    const Statistics s = statistics(&perlin_noise);
    EXPECT_NEAR(s.mean, 0, 0.01);
    EXPECT_NEAR(s.variance, 0.07, 0.02);
    EXPECT_GT(s.most, 0.7);
    EXPECT_LT(s.most, 1.1);
    const Statistics jumps = statistics(
        [](const Vec3& p) { return perlin_noise(p + Vec3(1e-3f, 0, 0)) - perlin_noise(p); });
    EXPECT_LT(jumps.most, 4e-3);
}

TEST(PerlinNoise, IsFiniteAnywhere) {
    const float inf = std::numeric_limits<float>::infinity();
    for (const float x : {1e9f, -1e30f, inf, -inf, std::nanf("")})
        EXPECT_TRUE(std::isfinite(perlin_noise({x, 0.5f, 0.5f}))) << x;
}

class NoiseTextureTest : public ::testing::Test {
  protected:
    Statistics of(const FloatTexture& texture) {
        return statistics([&](const Vec3& p) {
            TexturePoint point;
            point.p = p;
            return texture.evaluate(point);
        });
    }
    static float at(const FloatTexture& texture, const Vec3& p) {
        TexturePoint point;
        point.p = p;
        return texture.evaluate(point);
    }

    ShadingFixture scene_;
};

TEST_F(NoiseTextureTest, OneOctaveIsTheNoiseItself) {
    const auto fbm = scene_.make_float("fbm", {integer("octaves", 1)});
    const auto wrinkled = scene_.make_float("wrinkled", {integer("octaves", 1)});
    const Vec3 p(0.3f, 1.7f, -2.2f);
    EXPECT_EQ(at(*fbm, p), perlin_noise(p));
    EXPECT_EQ(at(*wrinkled, p), std::abs(perlin_noise(p)));
}

TEST_F(NoiseTextureTest, OctavesAddUp) {
    const auto fbm = scene_.make_float("fbm", {integer("octaves", 2), number("roughness", 0.25)});
    const Vec3 p(0.3f, 1.7f, -2.2f);
    EXPECT_FLOAT_EQ(at(*fbm, p), perlin_noise(p) + 0.25f * perlin_noise(p * 1.99f));
    EXPECT_THROW(scene_.make_float("fbm", {integer("octaves", 0)}), InputError);
}

// Octaves hardly correlate: variances add up with the squares of the weights.
TEST_F(NoiseTextureTest, VariancesOfOctavesAddUp) {
    const double one = statistics(&perlin_noise).variance;
    const Statistics s = of(*scene_.make_float("fbm"));
    const double weights = (1 - std::pow(0.64, 8)) / (1 - 0.64);
    EXPECT_NEAR(s.variance, one * weights, 0.15 * one * weights);
    EXPECT_NEAR(s.mean, 0, 0.02);
    const Statistics wrinkled = of(*scene_.make_float("wrinkled"));
    EXPECT_GT(wrinkled.least, 0);
    EXPECT_GT(wrinkled.mean, 0.3);
}

TEST_F(NoiseTextureTest, WindIsWavesTimesGusts) {
    const auto windy = scene_.make_float("windy");
    const auto gusts = scene_.make_float("fbm", {integer("octaves", 3), number("roughness", 0.5)});
    const auto waves = scene_.make_float("fbm", {integer("octaves", 6), number("roughness", 0.5)});
    const Vec3 p(3.3f, 1.7f, -2.2f);
    EXPECT_FLOAT_EQ(at(*windy, p), std::abs(at(*gusts, p * 0.1f)) * at(*waves, p));
}

TEST_F(NoiseTextureTest, MarbleLiesInLayersAcrossY) {
    const auto layers = scene_.make_color(
        "marble", {number("variation", 0), number("scale", 2), vector("scale", {1, 4, 1})});
    const auto color = [&](const Vec3& p) {
        TexturePoint point;
        point.p = p;
        return layers->evaluate(point);
    };
    const float pi = 3.14159265f;
    // Height 2 in space is 0.5 in the texture, times the marble's own scale 1.
    EXPECT_EQ(color({5, 2, -3}), color({-8, 2, 1}));
    const Rgb a = color({0, 0.3f, 0}), b = color({0, 0.3f + 4 * pi, 0});
    EXPECT_NEAR(a.x, b.x, 1e-4f);  // a turn of the sine is 2 pi * 4 / 2
    // The sine at its end: the last control colour, times the contrast.
    const Rgb end = color({0, pi, 0});
    EXPECT_NEAR(end.x, 1.5f * 0.58f, 1e-3f);
    EXPECT_NEAR(end.z, 1.5f * 0.61f, 1e-3f);
    for (int i = 0; i < 100; ++i) {
        const Rgb c = color({0, static_cast<float>(i), 0});
        EXPECT_GE(c.x, 0.3f);
        EXPECT_LE(c.z, 0.9151f);
    }
}

}  // namespace
}  // namespace lxs::noise_texture_test
