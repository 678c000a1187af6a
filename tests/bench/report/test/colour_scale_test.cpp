// Protects maps in colours: shrinking, the choice of a scale, and which value has which colour.
#include "colour_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bench::test::colour_scale_test {
namespace {

/// One row.
PixelMap row(std::vector<double> values) {
    return {int(values.size()), 1, std::move(values)};
}

TEST(PixelMap, ShrinkingTakesBoxMeansAndKeepsTheMean) {
    const PixelMap map{4, 2, {1, 3, 0, 0, 5, 7, 0, 8}};
    const PixelMap half = shrink(map, 2);
    EXPECT_EQ(half.width_px, 2);
    EXPECT_EQ(half.height_px, 1);
    EXPECT_EQ(half.values, (std::vector<double>{4, 2}));
    const PixelMap uneven = shrink(row({6, 1, 3, 4, 6}), 2);  // boxes of two and three
    EXPECT_EQ(uneven.values, (std::vector<double>{3.5, 13.0 / 3}));
    EXPECT_EQ(shrink(map, 9).values, map.values);
}

TEST(PixelMap, Quantiles) {
    EXPECT_EQ(quantile({4, 0, 3, 1, 2}, 0), 0);
    EXPECT_EQ(quantile({4, 0, 3, 1, 2}, 0.5), 2);
    EXPECT_EQ(quantile({4, 0, 3, 1, 2}, 1), 4);
}

TEST(ColourScale, LinearFromZeroWhereValuesAreClose) {
    const std::vector maps{row({0, 1, 2}), row({3, 4})};
    const ColourScale scale = choose_scale(maps);
    EXPECT_FALSE(scale.logarithmic);
    EXPECT_EQ(scale.low, 0);
    EXPECT_EQ(scale.high, 3);  // of 1, 2, 3, 4 the last is beyond 99.5 %
}

TEST(ColourScale, LogarithmicWhereTheyAreNotUpToFourDecades) {
    std::vector<double> values{0, -1};
    for (int i = 0; i <= 200; ++i)
        values.push_back(std::pow(10, i / 100.0));
    const ColourScale scale = choose_scale(std::vector{row(values)});
    EXPECT_TRUE(scale.logarithmic);
    EXPECT_NEAR(scale.low, std::pow(10, 0.1), 1e-9);
    EXPECT_NEAR(scale.high, std::pow(10, 1.99), 1e-9);
    for (double& value : values)
        value = std::pow(value, 5);
    const ColourScale wide = choose_scale(std::vector{row(values)});
    EXPECT_NEAR(wide.low, wide.high / 1e4, 1e-9 * wide.high);
}

TEST(ColourScale, NothingPositive) {
    const ColourScale scale = choose_scale(std::vector{row({0, 0})});
    EXPECT_EQ(scale.low, 0);
    EXPECT_EQ(scale.high, 1);
    EXPECT_FALSE(scale.logarithmic);
}

TEST(ColourScale, ColoursOfEndsMiddleAndWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const PixelMap map = row({0.5, 1, 10, 100, 1e6, 0, nan});
    const DisplayImage shown = colour_map(map, {1, 100, true});
    const Rgb8 first = kMapColours.front(), last = kMapColours.back();
    EXPECT_EQ(shown.pixels[0], first);
    EXPECT_EQ(shown.pixels[1], first);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(shown.pixels[2][c], kMapColours[4][c], 3);  // up to a step of colour
    EXPECT_EQ(shown.pixels[3], last);
    EXPECT_EQ(shown.pixels[4], last);
    EXPECT_EQ(shown.pixels[5], first);
    EXPECT_EQ(shown.pixels[6], first);
}

}  // namespace
}  // namespace bench::test::colour_scale_test
