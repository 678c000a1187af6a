// Colours of reflectances under LuxRender's white lamps.
#include "lxs/spectrum/reflectance_colour.h"

#include <gtest/gtest.h>

#include <vector>

#include "lxs/spectrum/colour_matching.h"

namespace lxs::reflectance_colour_test {
namespace {

// From LuxRender 1.9's spectra of colours under its white, seen through the CIE 1931 observer in
// steps of 1 nm. Ours has steps of 5 nm, linear in between.
TEST(ReflectanceColour, ComesBackFromLuxRendersSpectra) {
    struct Row {
        Rgb written, seen;
    };
    const std::vector<Row> rows{{{1, 0, 0}, {1.0122f, -0.0045f, 0.0025f}},
                                {{0, 1, 0}, {-0.0083f, 1.0045f, 0.0162f}},
                                {{0, 0, 1}, {-0.0049f, -0.0020f, 0.9833f}},
                                {{0, 1, 1}, {-0.0020f, 1.0017f, 0.9946f}},
                                {{1, 0, 1}, {1.0243f, -0.0115f, 0.9916f}},
                                {{1, 1, 0}, {1.0007f, 1.0019f, 0.0231f}},
                                {{0.3f, 0.1f, 0.4f}, {0.3044f, 0.0975f, 0.3966f}},
                                {{0.6f, 0.35f, 0.2f}, {0.6032f, 0.3492f, 0.2041f}},
                                {{0.2f, 0.5f, 0.8f}, {0.1979f, 0.4999f, 0.7934f}},
                                {{0.5f, 0.5f, 0.1f}, {0.5003f, 0.5007f, 0.1092f}}};
    for (const Row& row : rows) {
        const Rgb seen = colour_of_reflectance(row.written);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c], row.seen[c], 1.5e-3f) << row.written << " channel " << c;
    }
}

TEST(ReflectanceColour, GreysStayAsTheyAre) {
    for (const float grey : {0.0f, 0.1f, 0.37f, 1.0f})
        EXPECT_EQ(colour_of_reflectance(Rgb(grey)), Rgb(grey));
}

TEST(ReflectanceColour, IsUndone) {
    for (const Rgb& seen : {Rgb(0.7f, 0.2f, 0.1f), Rgb(0.3f, 0.31f, 0.3f), Rgb(0.9f, 0.05f, 0.6f),
                            Rgb(0.1f, 0.5f, 0.9f), Rgb(0.4f), Rgb(3, 2, 1)}) {
        const Rgb written = reflectance_of_colour(seen);
        EXPECT_LT((colour_of_reflectance(written) - seen).length(), 1e-4f) << seen;
    }
    // No reflectance has these; the nearest have no component below 0.
    for (const Rgb& seen : {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(1, 0, 1)}) {
        const Rgb written = reflectance_of_colour(seen);
        EXPECT_LT((colour_of_reflectance(written) - seen).length(), 0.03f) << seen;
        EXPECT_GE(std::min({written.x, written.y, written.z}), 0) << seen;
    }
}

TEST(ReflectanceColour, ChangesSmoothlyFromOneOrderOfChannelsToTheNext) {
    for (const Rgb& tie : {Rgb(0.5f, 0.5f, 0.2f), Rgb(0.2f, 0.5f, 0.5f), Rgb(0.5f, 0.2f, 0.5f)}) {
        const Rgb at = colour_of_reflectance(tie);
        for (int c = 0; c < 3; ++c) {
            Rgb near = tie;
            near[c] += 1e-5f;
            EXPECT_LT((colour_of_reflectance(near) - at).length(), 3e-5f);
        }
    }
}

TEST(WhiteLamp, ShowsAWhiteSurfaceWhite) {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += white_lamp_response(nm);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c], 1, 1e-12);
}

}  // namespace
}  // namespace lxs::reflectance_colour_test
