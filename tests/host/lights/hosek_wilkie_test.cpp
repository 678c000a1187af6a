// Protects the Hosek-Wilkie sky: its data as the authors released them, and what the model makes of
// them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "hosek_wilkie_data.h"
#include "hosek_wilkie_sky.h"

namespace lxs::test::hosek_wilkie_test {
namespace {

/// FNV-1a of the numbers, printed by "%.6e".
class Checksum {
  public:
    void add(float value) {
        for (const char c : fmt::format("{:.6e} ", value))
            hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

TEST(HosekWilkieData, IsTheAuthorsRelease) {
    Checksum checksum;
    for (const HosekWilkieBand& band : kHosekWilkieData) {
        for (const auto& turbidity : band.coefficients)
            for (const auto& point : turbidity)
                for (const float c : point)
                    checksum.add(c);
        for (const auto& turbidity : band.radiance)
            for (const float r : turbidity)
                checksum.add(r);
    }
    EXPECT_EQ(checksum.value(), 0xa62eb4b3747f5c0cu);
}

/// Read from the release's file by eye: the order of the tables is right, too.
TEST(HosekWilkieData, StandsInItsPlaces) {
    const HosekWilkieBand &first = kHosekWilkieData.front(), &last = kHosekWilkieData.back();
    EXPECT_EQ(first.coefficients[0][0][0], -2.97429f);
    EXPECT_EQ(last.coefficients[9][5][8], 0.6773818f);
    EXPECT_EQ(kHosekWilkieData[4].coefficients[7][0][3], 1.742373f);
    EXPECT_EQ(first.radiance[0][0], 0.002494129f);
    EXPECT_EQ(last.radiance[9][4], 0.1874982f);
}

Vec3 at_elevation(double degrees) {
    const double e = degrees * std::numbers::pi / 180;
    return Vec3(float(std::cos(e)), 0, float(std::sin(e)));
}

/// A clear sky's diffuse illuminance: some 10 klx at 40 degrees, rising with the sun.
TEST(HosekWilkieSky, IlluminanceOfAClearSky) {
    const auto illuminance = [](double elevation) {
        const HosekWilkieSky sky(at_elevation(elevation), 2.5);
        constexpr int kSide = 100;
        double sum = 0;
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                const float z = std::sqrt((float(i) + 0.5f) / kSide), s = std::sqrt(1 - z * z);
                const float phi = 2 * std::numbers::pi_v<float> * (float(j) + 0.5f) / kSide;
                sum += luminance(sky.radiance(Vec3(s * std::cos(phi), s * std::sin(phi), z)));
            }
        }
        return std::numbers::pi * sum / (kSide * kSide);
    };
    EXPECT_GT(illuminance(40), 8000);
    EXPECT_LT(illuminance(40), 20000);
    EXPECT_GT(illuminance(40), 2 * illuminance(5));
    EXPECT_GT(illuminance(70), illuminance(40));
}

TEST(HosekWilkieSky, InterpolatesSmoothly) {
    const Vec3 w = Vec3(0.3f, 0.5f, 0.6f).normalized();
    const auto value = [&](double elevation, double turbidity) {
        return HosekWilkieSky(at_elevation(elevation), turbidity).radiance(w).y;
    };
    // At a whole turbidity the two sides meet; between two it is their mean in no coefficient's
    // sense, but close to it.
    EXPECT_NEAR(value(30, 2.9999) / value(30, 3.0001), 1, 1e-3);
    EXPECT_NEAR(value(30, 3.5) / ((value(30, 3) + value(30, 4)) / 2), 1, 0.03);
    EXPECT_NEAR(value(29.99, 3) / value(30.01, 3), 1, 1e-2);
}

TEST(HosekWilkieSky, IsBrightestAtTheSunAndBlue) {
    const Vec3 sun = at_elevation(45);
    const HosekWilkieSky sky(sun, 2);
    const Vec3 opposite(-sun.x, 0, sun.z);
    EXPECT_GT(luminance(sky.radiance(sun)), 2 * luminance(sky.radiance(opposite)));
    EXPECT_GT(sky.radiance(opposite).z, 2 * sky.radiance(opposite).x);
}

}  // namespace
}  // namespace lxs::test::hosek_wilkie_test
