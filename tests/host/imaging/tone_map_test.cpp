// Protects tone mapping: monotone curves, values in range, each kernel's defining property.
#include "tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lxs::test::tone_map_test {
namespace {

using Kernel = ToneMapSettings::Kernel;
using Clamp = ToneMapSettings::Clamp;

constexpr Kernel kKernels[] = {Kernel::AutoLinear, Kernel::Linear,   Kernel::Reinhard,
                               Kernel::Contrast,   Kernel::MaxWhite, Kernel::NonLinear};

std::vector<Rgb> grey_ramp() {
    std::vector<Rgb> ramp{Rgb(0.0f)};
    for (int step = -60; step < 60; ++step) {
        ramp.emplace_back(std::pow(1.3f, static_cast<float>(step)));
    }
    return ramp;
}

TEST(ToneMap, BrighterIsNeverDarker) {
    for (const Kernel kernel : kKernels) {
        ToneMapSettings settings;
        settings.kernel = kernel;
        const auto bytes = tone_map(grey_ramp(), settings);
        EXPECT_EQ(bytes.front(), 0);
        for (std::size_t i = 3; i < bytes.size(); ++i) {
            EXPECT_GE(bytes[i], bytes[i - 3]) << "kernel " << static_cast<int>(kernel);
        }
    }
}

// The kernels that look at the image as a whole would take a brighter image back to where it was.
TEST(ToneMap, AStopDoublesWhatEveryKernelGives) {
    for (const Kernel kernel : kKernels) {
        ToneMapSettings settings;
        settings.kernel = kernel;
        settings.gamma = 1;
        settings.exposure_stops = -4;  // no channel is cut off
        const auto dark = tone_map(grey_ramp(), settings);
        settings.exposure_stops = -3;
        const auto bright = tone_map(grey_ramp(), settings);
        int compared = 0;
        for (std::size_t i = 0; i < dark.size(); ++i) {
            if (bright[i] == 255) continue;
            EXPECT_NEAR(bright[i], 2 * dark[i], 1) << "kernel " << static_cast<int>(kernel);
            compared += dark[i] > 4 ? 1 : 0;
        }
        EXPECT_GT(compared, 0) << "kernel " << static_cast<int>(kernel);
    }
}

TEST(ToneMap, ExtremesStayInRange) {
    // A wrong conversion of an infinity or NaN to a byte would be caught by the sanitizers.
    const float largest = std::numeric_limits<float>::max();
    const float smallest = std::numeric_limits<float>::denorm_min();
    for (const Kernel kernel : kKernels) {
        for (const Clamp clamp : {Clamp::Luminance, Clamp::Hue, Clamp::Darken, Clamp::Cut}) {
            ToneMapSettings settings;
            settings.kernel = kernel;
            settings.clamp = clamp;
            EXPECT_EQ(tone_map(std::vector<Rgb>(4, Rgb(0.0f)), settings),
                      std::vector<std::uint8_t>(12, 0));
            EXPECT_EQ(tone_map(std::vector<Rgb>{Rgb(largest), Rgb(smallest), Rgb(0, 0, largest)},
                               settings)
                          .size(),
                      9u);
        }
    }
}

TEST(ToneMap, AutoLinearPutsTheMeanAboveMiddleGrey) {
    // mean -> 1.25 * (118/255)^2.2, encoded with gamma 2.2.
    const auto bytes = tone_map(std::vector<Rgb>(10, Rgb(37.5f)), {});
    const double expected = 255 * std::pow(1.25 * std::pow(118.0 / 255, 2.2), 1 / 2.2);
    EXPECT_NEAR(bytes[0], expected, 0.51);
}

TEST(ToneMap, LinearScalesWithExposure) {
    ToneMapSettings settings;
    settings.kernel = Kernel::Linear;
    settings.gamma = 1;
    settings.linear_sensitivity = 100;
    settings.linear_exposure = 0.5;
    settings.linear_fstop = 2;
    // 0.5 / 4 * 100 * 0.065 * 118 / 255 = 0.37598 per unit.
    EXPECT_EQ(tone_map(std::vector<Rgb>{Rgb(1.0f)}, settings)[0], std::lround(255 * 0.37598));
    settings.linear_fstop = 4;
    EXPECT_EQ(tone_map(std::vector<Rgb>{Rgb(1.0f)}, settings)[0], std::lround(255 * 0.093995));
}

TEST(ToneMap, MaxWhiteMakesTheBrightestWhite) {
    ToneMapSettings settings;
    settings.kernel = Kernel::MaxWhite;
    const auto bytes = tone_map(std::vector<Rgb>{Rgb(8.0f), Rgb(4.0f)}, settings);
    EXPECT_EQ(bytes[0], 255);
    EXPECT_EQ(bytes[3], std::lround(255 * std::pow(0.5, 1 / 2.2)));
}

TEST(ToneMap, ReinhardBurnsOutWhereAsked) {
    // One grey level: its scaled luminance is the key 0.1; with burn 0.1 it becomes 0.1 exactly.
    ToneMapSettings settings;
    settings.kernel = Kernel::Reinhard;
    settings.gamma = 1;
    settings.reinhard_burn = 0.1;
    const std::vector<Rgb> grey(5, Rgb(123.0f));
    const double key = 0.1;
    EXPECT_NEAR(tone_map(grey, settings)[0], 255 * key * (1 + key / 0.01) / (1 + key), 0.51);
    settings.reinhard_postscale = 0.5;
    EXPECT_NEAR(tone_map(grey, settings)[0], 127.5 * key * (1 + key / 0.01) / (1 + key), 0.51);
}

/// Bytes of grey levels under `settings` with gamma 1, and what they should be.
void expect_greys(ToneMapSettings settings, const std::vector<float>& levels,
                  const std::vector<double>& expected) {
    settings.gamma = 1;
    std::vector<Rgb> image;
    image.reserve(levels.size());
    for (const float level : levels)
        image.emplace_back(level);
    const auto bytes = tone_map(image, settings);
    for (std::size_t i = 0; i < levels.size(); ++i)
        EXPECT_NEAR(bytes[3 * i], 255 * std::min(expected[i], 1.0), 0.51) << levels[i];
}

// LuxRender's own formulas. Reinhard: with a = 0.1 / (geometric mean), luminance Y becomes
// postscale * a Y (1 + p / burn^2) / (1 + p), where p = a Y / prescale.
TEST(ToneMap, ReinhardDividesByPrescale) {
    ToneMapSettings settings;
    settings.kernel = Kernel::Reinhard;
    settings.reinhard_postscale = 3;
    const double a = 0.1 / 2;  // geometric mean of 1 and 4
    for (const double prescale : {0.05, 1.0, 4.0}) {
        settings.reinhard_prescale = prescale;
        std::vector<double> expected;
        for (const double y : {1.0, 4.0}) {
            const double p = a * y / prescale;
            expected.push_back(3 * a * y * (1 + p / 36) / (1 + p));
        }
        expect_greys(settings, {1, 4}, expected);
    }
}

// Ward: ((1.219 + ywa^0.4) / (1.219 + Y^0.4))^2.5 / 100, Y being the geometric mean of the image.
TEST(ToneMap, ContrastAdaptsToTheImage) {
    ToneMapSettings settings;
    settings.kernel = Kernel::Contrast;
    for (const double ywa : {1.0, 50.0}) {
        settings.contrast_ywa = ywa;
        const double scale =
            std::pow((1.219 + std::pow(ywa, 0.4)) / (1.219 + std::pow(2.0, 0.4)), 2.5) / 100;
        expect_greys(settings, {1, 4}, {scale, 4 * scale});
    }
}

// The brightest is told by luminance: of a bright blue pixel it is 0.0722 of the blue.
TEST(ToneMap, MaxWhiteGoesByLuminance) {
    ToneMapSettings settings;
    settings.kernel = Kernel::MaxWhite;
    settings.gamma = 1;
    const auto bytes = tone_map(std::vector<Rgb>{Rgb(1.0f), Rgb(0, 0, 10), Rgb(0.5f)}, settings);
    EXPECT_EQ(bytes[0], 255);
    EXPECT_EQ(bytes[6], 128);
}

// y (1 + y / Y^2) / (1 + y), Y being the geometric mean of the image.
TEST(ToneMap, NonLinearMakesTheMeanWhite) {
    ToneMapSettings settings;
    settings.kernel = Kernel::NonLinear;
    expect_greys(settings, {1, 4}, {1.25 / 2, 4 * 2.0 / 5});
}

TEST(ToneMap, ClampMethodsDiffer) {
    ToneMapSettings settings;
    settings.kernel = Kernel::MaxWhite;
    settings.gamma = 1;
    const std::vector<Rgb> image{Rgb(1.0f), Rgb(1.0f, 0.5f, 0.0f)};
    EXPECT_EQ(tone_map(image, settings)[4], 128) << "in range: untouched";

    settings.kernel = Kernel::Linear;
    settings.linear_sensitivity = 1 / 0.065;
    settings.linear_fstop = 1;
    settings.linear_gamma = 0;  // scale 1
    const std::vector<Rgb> bright{Rgb(2.0f, 0.5f, 0.0f)};
    settings.clamp = Clamp::Cut;
    EXPECT_EQ(tone_map(bright, settings), (std::vector<std::uint8_t>{255, 128, 0}));
    settings.clamp = Clamp::Darken;
    EXPECT_EQ(tone_map(bright, settings), (std::vector<std::uint8_t>{255, 64, 0}));
    settings.clamp = Clamp::Hue;  // 1/3 + 0.4 (c - 1/3)
    EXPECT_EQ(tone_map(bright, settings), (std::vector<std::uint8_t>{255, 102, 51}));
    settings.clamp = Clamp::Luminance;
    const auto lum = tone_map(bright, settings);
    const double y = 0.2126 * lum[0] + 0.7152 * lum[1] + 0.0722 * lum[2];
    EXPECT_EQ(lum[0], 255);
    EXPECT_NEAR(y / 255, 0.2126 * 2 + 0.7152 * 0.5, 0.005) << "luminance is kept";
}

TEST(ToneMap, LuminanceIsThatOfTheFilmsColours) {
    ToneMapSettings settings;
    settings.kernel = Kernel::MaxWhite;
    settings.gamma = 1;
    settings.luminance_weights = {0.5, 0.4, 0.1};
    const std::vector<Rgb> image{Rgb(0, 0, 2.0f), Rgb(1.0f)};  // luminances 0.2 and 1
    EXPECT_EQ(tone_map(image, settings), (std::vector<std::uint8_t>{0, 0, 255, 255, 255, 255}));
    settings.clamp = Clamp::Luminance;
    const auto bytes = tone_map(image, settings);
    // 0.2 + t (2 - 0.2) = 1 for t = 4/9.
    EXPECT_EQ(bytes[0], std::lround(255 * (0.2 - 0.2 * 4 / 9)));
    EXPECT_EQ(bytes[2], 255);
}

}  // namespace
}  // namespace lxs::test::tone_map_test
