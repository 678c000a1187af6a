// Protects the pixel filters: their published values, their symmetry and their support.
#include "pixel_filter.h"

#include <gtest/gtest.h>

#include "filter_functions.h"
#include "scene_options.h"

namespace lxs::test {
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

TEST(PixelFilter, TableFollowsTheFunction) {
    const PixelFilter f = filter("gaussian", {real("alpha", 2)});
    for (int step = 0; step < 40; ++step) {
        const float x = 0.05f * static_cast<float>(step);
        const double expected = gaussian_1d(x, 2, 2) * gaussian_1d(0.3, 2, 2);
        EXPECT_NEAR(f.weight(x, 0.3f), expected, 0.03) << x;
    }
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
    EXPECT_NEAR(f.weight(0.6f, 0.8f), mitchell_1d(1, 1.0 / 3, 1.0 / 3), 0.02);
}

}  // namespace
}  // namespace lxs::test
