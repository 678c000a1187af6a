// Protects the engine from the units of length and of light: powers of two of either change no bit
// of the image (but the factor itself, for light), and a place far from the origin is said once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "placed_room.h"
#include "stress_case.h"
#include "ways.h"

namespace aips::scale_test {
namespace {

constexpr std::uint32_t kSize = 12;
constexpr unsigned kPasses = 4;

mock::Rendering rendered(const stress::RoomPlace& place, const stress::Way& way) {
    const mock::View view = stress::placed_room(place, kSize);
    return mock::render(view.scene, view.camera, kSize, kSize, way.settings, kPasses);
}

/// Pixels that are not `factor` times those of `b`.
std::size_t different(const mock::Rendering& a, const mock::Rendering& b, float factor = 1) {
    const auto first = a.film.image(), second = b.film.image();
    std::size_t count = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        count += first[i] == second[i] * factor ? 0 : 1;
    return count;
}

TEST(StressEngineScale, PowersOfTwoOfLengthKeepEveryBit) {
    const auto exponents =
        stress::sized(std::vector{-20, 20}, std::vector{-30, -20, -10, 10, 20, 30});
    for (const stress::Way& way : stress::ways(1, 2000, true)) {
        const auto unscaled = rendered({}, way);
        ASSERT_GT(unscaled.film.mean(), 0);
        for (const int exponent : exponents) {
            const auto scaled = rendered({std::exp2(float(exponent))}, way);
            EXPECT_EQ(different(scaled, unscaled), 0u) << way.name << ", 2^" << exponent;
            EXPECT_TRUE(scaled.statistics.refused.empty()) << way.name;
        }
    }
    stress::record("a mock room at 2^" + std::to_string(exponents.front()) + " to 2^" +
                       std::to_string(exponents.back()) + " units, nine ways",
                   "0 pixels differ");
}

/// 2^40 and 2^-40 are about 1e12 and 1e-12.
TEST(StressEngineScale, PowersOfTwoOfLightKeepEveryBit) {
    for (const stress::Way& way : stress::ways(2, 2000, true)) {
        const auto unscaled = rendered({}, way);
        for (const int exponent : {-40, 40}) {
            const auto factor = std::exp2(float(exponent));
            stress::RoomPlace place;
            place.strength = factor;
            const auto scaled = rendered(place, way);
            EXPECT_EQ(different(scaled, unscaled, factor), 0u) << way.name << ", 2^" << exponent;
            EXPECT_TRUE(scaled.statistics.refused.empty()) << way.name;
        }
    }
    stress::record("lamps 2^-40 and 2^40 times as strong, nine ways",
                   "0 pixels differ but by the factor");
}

TEST(StressEngineScale, LostPrecisionIsSaidOnce) {
    const auto warnings = [](float distance) {
        stress::RoomPlace place;
        place.middle = {0, distance, 0};
        const auto r = rendered(place, stress::ways(3, 500, false).front());
        EXPECT_TRUE(r.statistics.refused.empty()) << distance;
        for (const Rgb& pixel : r.film.image())
            EXPECT_TRUE(std::isfinite(luminance(pixel))) << distance;
        return std::count_if(r.log.lines.begin(), r.log.lines.end(), [](const std::string& line) {
            return line.find("positions are rounded to") != std::string::npos;
        });
    };
    for (const float distance : {0.0f, 1e3f, 1e5f})
        EXPECT_EQ(warnings(distance), 0) << distance;
    EXPECT_EQ(warnings(1e6f), 1);
    stress::record("a room of 12 x 12 pixels, 1e3 to 1e6 units from the origin",
                   "warns once at 1e6; images finite");
}

}  // namespace
}  // namespace aips::scale_test
