// Infinite lights: LuxRender's map orientation, power, and light that comes from everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "latlong_map.h"
#include "light_cases.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "piecewise_2d.h"

namespace lxs::test::infinite_light_test {
namespace {

constexpr double kPi = std::numbers::pi;

Vec3 direction_at(double s, double t) {
    const double phi = 2 * kPi * s, theta = kPi * t;
    return Vec3(float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)),
                float(std::cos(theta)));
}

TEST(InfiniteLight, ConstantHasPiTimesRadianceOnAnyPlane) {
    const auto light = make_one(
        "infinite", {numbers("color", "L", {0.25, 0.3, 0.35}), numbers("float", "gain", {2})});
    EXPECT_TRUE(light->at_infinity());
    const Rgb colour = colour_of_illuminant(Rgb(0.25f, 0.3f, 0.35f));
    EXPECT_FLOAT_EQ(light->escaped(Vec3(0, 0, -1)).y, 2 * colour.y);
    const double r = scene_sphere().radius;
    EXPECT_NEAR(light->power() / (4 * kPi * kPi * r * r * 2 * luminance(colour)), 1, 1e-5);
}

// As in LuxRender 1.9's image of a map: s runs with the azimuth from +x over +y, t from +z down.
TEST(InfiniteLight, MapOrientation) {
    const auto light =
        make_one("infinite", {text("mapname", probe_image()), numbers("color", "L", {1, 1, 2})});
    const auto expect_pixel = [&](const Rgb& found, const Rgb& pixel) {
        const Rgb expected = colour_of_filtered_illuminant(pixel, Rgb(1, 1, 2));
        EXPECT_NEAR((found - expected).length(), 0, 1e-4 * expected.length()) << found;
    };
    expect_pixel(light->escaped(direction_at(12.0 / 64, 7.5 / 32)), Rgb(40, 30, 20));
    expect_pixel(light->escaped(direction_at(32.5 / 64, 20.5 / 32)), Rgb(0.52f, 0.3f, 0.5f));
    Matrix turned;
    turned.setAxisAngle(Imath::V3d(0, 0, 1), kPi / 2);
    const auto rotated = make_one("infinite", {text("mapname", probe_image())}, turned);
    EXPECT_NEAR(rotated->escaped(direction_at(12.0 / 64 + 0.25, 7.5 / 32)).x,
                colour_of_filtered_illuminant(Rgb(40, 30, 20), Rgb(1.0f)).x, 1e-3);
}

TEST(InfiniteLight, PowerIsTheMeanOfItsPhotons) {
    const auto light = make_one("infinite", {text("mapname", probe_image())});
    Random random(37);
    double sum = 0, squares = 0;
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
        EmissionSample s;
        ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
        sum += luminance(s.power);
        squares += luminance(s.power) * luminance(s.power);
    }
    const double mean = sum / kCount;
    const double error = std::sqrt((squares / kCount - mean * mean) / kCount);
    EXPECT_NEAR(mean, light->power(), 4 * error + 2e-3 * mean);
    EXPECT_LT(error * std::sqrt(double(kCount)) / mean, 0.5) << "importance sampling is poor";
}

TEST(InfiniteLight, GammaAndMissingFile) {
    const auto light =
        make_one("infinite", {text("mapname", probe_image()), numbers("float", "gamma", {2})});
    EXPECT_NEAR(light->escaped(direction_at(12.0 / 64, 7.5 / 32)).x,
                colour_of_filtered_illuminant(Rgb(1600, 900, 400), Rgb(1.0f)).x, 0.1);
    EXPECT_THROW(make_one("infinite", {text("mapname", "/nowhere/no.exr")}), InputError);
}

TEST(InfiniteLight, AnIlluminanceIsThatOfALyingPatch) {
    const auto light =
        make_one("infinite", {text("mapname", probe_image()), numbers("float", "illuminance", {7}),
                              numbers("float", "gain", {2})});
    double sum = 0;
    constexpr int kRows = 400;  // by equal squares of the sine: each as much of the cosine
    for (int y = 0; y < kRows; ++y) {
        const double polar = std::asin(std::sqrt((y + 0.5) / kRows));
        for (int x = 0; x < kRows; ++x)
            sum += double(luminance(light->escaped(direction_at((x + 0.5) / kRows, polar / kPi))));
    }
    EXPECT_NEAR(sum * kPi / (double(kRows) * kRows), 2 * 7, 0.02 * 14);
}

TEST(LatLongMap, BlackAndBadPixels) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const LatLongMap bad(2, 1, {Rgb(nan, -1, 2), Rgb(std::numeric_limits<float>::infinity())});
    EXPECT_EQ(bad.lookup(Vec2(0.25f, 0.5f)), Rgb(0, 0, 2));
    const LatLongMap black(4, 2, std::vector<Rgb>(8, Rgb(0.0f)));
    EXPECT_FALSE(black.importance().positive());
}

// The density must be positive wherever the bilinear lookup is, or light would be lost.
TEST(LatLongMap, ImportanceCoversTheInterpolation) {
    std::vector<Rgb> pixels(std::size_t{128}, Rgb(0.0f));
    pixels[std::size_t{3} * 16] = Rgb(1.0f);  // its footprint wraps around
    const LatLongMap map(16, 8, pixels);
    const Piecewise2D importance = map.importance();
    Random random(41);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 st(random(), random());
        if (max_component(map.lookup(st)) > 0) {
            EXPECT_GT(importance.density(st), 0);
        }
    }
}

TEST(Piecewise2D, SampleStatesItsDensityAndCoversTheSquare) {
    const Piecewise2D grid(3, 2, {1, 0, 3, 2, 2, 0});
    for (const Vec2& u : {Vec2(0, 0), Vec2(0x1.fffffep-1f, 0x1.fffffep-1f), Vec2(0.3f, 0.6f)}) {
        float density = 0;
        const Vec2 p = grid.sample(u, density);
        EXPECT_GT(density, 0);
        EXPECT_EQ(density, grid.density(p));
        EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
    }
    EXPECT_FLOAT_EQ(grid.density(Vec2(0.9f, 0.1f)), 3.0f * 6 / 8);
    EXPECT_EQ(grid.density(Vec2(0.5f, 0.1f)), 0);
}

}  // namespace
}  // namespace lxs::test::infinite_light_test
