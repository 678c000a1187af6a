// Protects the pixel filters: their published values, their symmetry and their support.
#include "pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "filter_functions.h"
#include "scene_options.h"

namespace lxs::test::pixel_filter_test {
namespace {

constexpr const char* kFilters[] = {"blackmanharris", "box",  "catmullrom", "gaussian",
                                    "mitchell",       "sinc", "triangle"};

PixelFilter filter(const std::string& plugin, std::vector<ParameterValue> values = {}) {
    SceneContents contents = empty_scene();
    set_option(contents, "PixelFilter", plugin, std::move(values));
    RecordedDiagnostics diagnostics;
    return make_pixel_filter(contents, diagnostics);
}

TEST(FilterFunctions, MitchellHasThePublishedValues) {
    // Mitchell & Netravali 1988: k(0) = (6 - 2B) / 6, k(1) = B / 6, k(2) = 0.
    EXPECT_NEAR(mitchell_1d(0, 1.0 / 3, 1.0 / 3), 8.0 / 9, 1e-12);
    EXPECT_NEAR(mitchell_1d(1, 1.0 / 3, 1.0 / 3), 1.0 / 18, 1e-12);
    EXPECT_EQ(mitchell_1d(2, 1.0 / 3, 1.0 / 3), 0);
    EXPECT_LT(mitchell_1d(1.5, 1.0 / 3, 1.0 / 3), 0);
    // B = 0, C = 1/2 is Catmull-Rom's: it interpolates.
    EXPECT_EQ(mitchell_1d(0, 0, 0.5), 1);
    EXPECT_NEAR(mitchell_1d(1, 0, 0.5), 0, 1e-12);
}

TEST(FilterFunctions, MitchellSumsToOneAtAnyOffset) {
    for (int step = 0; step < 10; ++step) {
        const double offset = 0.1 * step;
        double sum = 0;
        for (int i = -3; i <= 3; ++i) {
            sum += mitchell_1d(i + offset, 1.0 / 3, 1.0 / 3);
        }
        EXPECT_NEAR(sum, 1, 1e-12) << "offset " << offset;
    }
}

TEST(FilterFunctions, OthersHaveTheirCentreAndEndValues) {
    EXPECT_NEAR(gaussian_1d(0, 2, 2), 1 - std::exp(-8.0), 1e-12);
    EXPECT_EQ(gaussian_1d(2, 2, 2), 0);
    EXPECT_EQ(triangle_1d(0.5, 2), 1.5);
    EXPECT_EQ(triangle_1d(-3, 2), 0);
    EXPECT_NEAR(blackman_harris_1d(0, 3.3), 1, 1e-12);
    EXPECT_NEAR(blackman_harris_1d(1.65, 3.3), 0.35875 - 0.14128, 1e-12);
    EXPECT_NEAR(blackman_harris_1d(3.299999, 3.3), 0.00006, 1e-6);
    EXPECT_EQ(blackman_harris_1d(3.3, 3.3), 0);
    EXPECT_EQ(lanczos_sinc_1d(0, 4, 3), 1);
    EXPECT_NEAR(lanczos_sinc_1d(4.0 / 3, 4, 3), 0, 1e-12);
    EXPECT_EQ(lanczos_sinc_1d(4, 4, 3), 0);
}

TEST(PixelFilter, IsEvenAndEndsAtItsRadius) {
    for (const char* name : kFilters) {
        const PixelFilter f = filter(name, {real("xwidth", 1.5), real("ywidth", 2.5)});
        for (const float x : {0.1f, 0.7f, 1.4f}) {
            for (const float y : {0.2f, 1.1f, 2.4f}) {
                EXPECT_EQ(f.weight(x, y), f.weight(-x, y)) << name;
                EXPECT_EQ(f.weight(x, y), f.weight(-x, -y)) << name;
            }
        }
        EXPECT_GT(f.weight(0, 0), 0) << name;
        EXPECT_EQ(f.weight(1.51f, 0), 0) << name;
        EXPECT_EQ(f.weight(0, -2.51f), 0) << name;
        EXPECT_EQ(f.weight(std::nanf(""), 0), 0) << name;
    }
}

/// LuxRender's rule: the filter, over what it weighs one sample for all pixels together.
double weight_of_sample(const std::function<double(double, double)>& f, double x, double y) {
    constexpr int kPixels = 40;
    double sum = 0;
    for (int j = -kPixels; j <= kPixels; ++j) {
        for (int i = -kPixels; i <= kPixels; ++i)
            sum += f(x + i, y + j);
    }
    return f(x, y) / sum;
}

TEST(PixelFilter, TableFollowsTheFunction) {
    const PixelFilter f = filter("gaussian", {real("alpha", 2)});
    const auto gaussian = [](double x, double y) {
        return gaussian_1d(x, 2, 2) * gaussian_1d(y, 2, 2);
    };
    for (int step = 0; step < 40; ++step) {
        const float x = 0.05f * static_cast<float>(step);
        EXPECT_NEAR(f.weight(x, 0.3f), weight_of_sample(gaussian, x, 0.3), 0.015) << x;
    }
}

/// What one sample gives all pixels together is what it has, whatever the filter and wherever the
/// sample lies in its pixel.
TEST(PixelFilter, WeightsOfASampleSumToOne) {
    for (const char* name : kFilters) {
        for (const double radius : {1.5, 2.0, 4.0}) {
            if (std::string_view(name) == "sinc" && radius < 4) continue;  // lobes within a pixel
            const PixelFilter f = filter(name, {real("xwidth", radius), real("ywidth", radius)});
            for (const float x : {0.013f, 0.22f, 0.49f, 0.71f, 0.987f}) {
                for (const float y : {0.024f, 0.31f, 0.52f, 0.96f}) {
                    double sum = 0;
                    for (int j = -6; j <= 6; ++j) {
                        for (int i = -6; i <= 6; ++i) {
                            sum += f.weight(x - 0.5f - static_cast<float>(i),
                                            y - 0.5f - static_cast<float>(j));
                        }
                    }
                    EXPECT_NEAR(sum, 1, 1e-5) << name << " at " << x << ", " << y;
                }
            }
        }
    }
}

/// Between the pixels of a cubic narrower than they are, weights stay of the order of one.
TEST(PixelFilter, NarrowCubicsDoNotExplode) {
    for (const double radius : {0.3, 0.6, 0.9, 1.0, 1.1}) {
        const PixelFilter f = filter("mitchell", {real("xwidth", radius), real("ywidth", radius)});
        for (float x = 0; x < 1.2f; x += 0.01f) {
            for (float y = 0; y < 1.2f; y += 0.01f)
                EXPECT_LT(std::abs(f.weight(x, y)), 10) << radius << ": " << x << ", " << y;
        }
    }
}

/// Share of the filter that is negative, of its positive part.
double negative_share(const PixelFilter& f) {
    double positive = 0, negative = 0;
    for (std::size_t row = 0; row < f.rows(); ++row) {
        for (std::size_t column = 0; column < f.columns(); ++column)
            (f.cell(column, row) < 0 ? negative : positive) += f.cell(column, row);
    }
    return -negative / positive;
}

// LuxRender's Evaluate with "supersample": d is the distance in radii, over 0.6 of the widened
// ones, and three cubics of support 1 stand at -2/3, 0 and 2/3, weighted by a1, a0, a1.
double luxrenders_supersampled(double d, double b, double c) {
    const auto cubic = [&](double x) {
        if (x >= 1) return 0.0;
        x = std::abs(2 * x);
        if (x > 1) {
            return (((-b / 6 - c) * x + (b + 5 * c)) * x + (-2 * b - 8 * c)) * x +
                   (4.0 / 3 * b + 4 * c);
        }
        return ((2 - 1.5 * b - c) * x + (-3 + 2 * b + c)) * x * x + (1 - b / 3);
    };
    const double a0 = (76 - 16 * b + 8 * c) / 81, a1 = (1 - a0) / 2;
    return a1 * cubic(d - 2.0 / 3) + a0 * cubic(d) + a1 * cubic(d + 2.0 / 3);
}

TEST(PixelFilter, SupersampledMitchellIsLuxRenders) {
    for (const auto& [b, c] : {std::pair(1.0 / 3, 1.0 / 3), std::pair(0.0, 0.5)}) {
        for (double x = 0; x < 4; x += 0.05)
            EXPECT_NEAR(supersampled_mitchell_1d(2 * x, b, c), luxrenders_supersampled(x, b, c),
                        1e-12);
    }
    const PixelFilter f = filter("mitchell", {flag("supersample", true), real("ywidth", 3)});
    EXPECT_FLOAT_EQ(f.radius_x(), 10.0f / 3);
    EXPECT_FLOAT_EQ(f.radius_y(), 5);
    const auto expected = [](double x, double y) {
        return luxrenders_supersampled(std::hypot(x / 2, y / 3), 1.0 / 3, 1.0 / 3);
    };
    for (const double x : {0.0, 0.4, 1.1, 1.9, 2.6, 3.2}) {
        for (const double y : {0.0, 0.7, 1.8, 3.1, 4.6}) {
            EXPECT_NEAR(f.weight(static_cast<float>(x), static_cast<float>(y)),
                        weight_of_sample(expected, x, y), 0.005)
                << x << ", " << y;
        }
    }
}

TEST(PixelFilter, SupersamplingLeavesAPercentOfNegativeLobes) {
    EXPECT_NEAR(negative_share(filter("mitchell")), 0.143, 0.005);
    EXPECT_NEAR(negative_share(filter("mitchell", {flag("supersample", true)})), 0.011, 0.002);
    EXPECT_TRUE(filter("mitchell").has_negative_weights());
    EXPECT_FALSE(filter("gaussian").has_negative_weights());
}

TEST(PixelFilter, DefaultsAreLuxRenders) {
    RecordedDiagnostics diagnostics;
    const PixelFilter none = make_pixel_filter(empty_scene(), diagnostics);
    EXPECT_EQ(none.radius_x(), 2);
    EXPECT_LT(none.weight(1.5f, 0), 0) << "mitchell has negative lobes";
    EXPECT_EQ(filter("box").radius_x(), 0.5f);
    EXPECT_EQ(filter("blackmanharris").radius_y(), 4);
    EXPECT_EQ(filter("sinc").radius_y(), 4);
    EXPECT_EQ(filter("triangle").radius_x(), 2);
}

TEST(PixelFilter, MitchellIsRadial) {
    const PixelFilter f = filter("mitchell");
    EXPECT_NEAR(
        f.weight(0.6f, 0.8f),
        weight_of_sample(
            [](double x, double y) { return mitchell_1d(std::hypot(x, y), 1.0 / 3, 1.0 / 3); }, 0.6,
            0.8),
        0.015);
}

}  // namespace
}  // namespace lxs::test::pixel_filter_test
