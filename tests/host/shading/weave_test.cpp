// Weaves against drafts on point paper, and the bow of yarns against their geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "materials/bent_yarn.h"
#include "materials/weave.h"

namespace lxs::shading::weave_test {
namespace {

/// As weavers draw it: a filled square is a warp end on top, the lowest row is the first pick.
using Draft = std::vector<std::string>;

Draft draft(const Weave& weave) {
    Draft rows;
    for (int pick = weave.ends; pick-- > 0;) {
        std::string row;
        for (int end = 0; end < weave.ends; ++end) {
            const WovenPlace place =
                locate_in_weave(weave, (static_cast<float>(end) + 0.4f) / weave.ends,
                                (static_cast<float>(pick) + 0.6f) / weave.ends);
            row += place.warp ? '#' : '.';
        }
        rows.push_back(row);
    }
    return rows;
}

TEST(Weave, AreThoseOfTheTextbooks) {
    EXPECT_EQ(draft({2, 1, 1}), (Draft{".#", "#."})) << "plain weave";
    EXPECT_EQ(draft({3, 2, 1}), (Draft{"#.#", ".##", "##."})) << "2/1 twill, its line to the right";
    EXPECT_EQ(draft({4, 2, 1}), (Draft{"#..#", "..##", ".##.", "##.."})) << "2/2 twill";
    EXPECT_EQ(draft({4, 3, 1}), (Draft{"##.#", "#.##", ".###", "###."})) << "3/1 twill";
    EXPECT_EQ(draft({5, 4, 2}), (Draft{"##.##", ".####", "###.#", "#.###", "####."})) << "satin";
}

TEST(Weave, PartsAreAsLongAsTheirFloats) {
    const Weave satin{5, 4, 2};
    int warps = 0;
    for (int i = 0; i < 25; ++i) {
        const int column = i % 5, row = i / 5;
        const float x = (static_cast<float>(column) + 0.5f) / 5;
        const float y = (static_cast<float>(row) + 0.5f) / 5;
        const WovenPlace place = locate_in_weave(satin, x, y);
        EXPECT_FLOAT_EQ(place.length, place.warp ? 4.0f : 1.0f);
        warps += place.warp;
    }
    EXPECT_EQ(warps, 20);
}

// Up the first end of a 3/1 twill: from the crossing that hides it to the next, over the repeat's
// edge, and the same in every repeat.
TEST(Weave, PlacesRunFromEndToEndOfAPart) {
    const Weave twill{4, 3, 1};
    const auto at = [&](float ends, float picks) {
        return locate_in_weave(twill, ends / 4, picks / 4);
    };
    // End 0 lies on top of picks 0, 2 and 3.
    EXPECT_FALSE(at(0.5f, 1.5f).warp);
    for (const float repeats : {0.0f, -4.0f, 8.0f}) {
        EXPECT_NEAR(at(0.5f, 2.001f + repeats).along, -1, 2e-3f);
        EXPECT_NEAR(at(0.5f, 3.5f + repeats).along, 0, 1e-5f);
        EXPECT_NEAR(at(0.5f, 4.5f + repeats).along, 2 / 3.0f, 1e-5f);
        EXPECT_NEAR(at(0.5f, 4.999f + repeats).along, 1, 2e-3f);
        EXPECT_NEAR(at(0.25f + repeats, 3.5f).across, -0.5f, 1e-5f);
    }
    // The weft that shows at end 0, pick 1.
    EXPECT_NEAR(at(0.75f, 1.1f).along, 0.5f, 1e-5f);
    EXPECT_NEAR(at(0.75f, 1.1f).across, -0.8f, 1e-5f);
}

TEST(Weave, AThickPickTakesItsShareOfTheRepeat) {
    const Weave slubbed{2, 1, 1, 3};
    EXPECT_TRUE(locate_in_weave(slubbed, 0.25f, 0.7f).warp);  // 3 of 4 belong to the first
    EXPECT_FALSE(locate_in_weave(slubbed, 0.25f, 0.8f).warp);
    EXPECT_FLOAT_EQ(locate_in_weave(slubbed, 0.25f, 0.7f).length, 3);
    EXPECT_NEAR(locate_in_weave(slubbed, 0.25f, 0.375f).along, 0, 1e-6f);
    EXPECT_FLOAT_EQ(locate_in_weave(slubbed, 0.75f, 0.7f).length, 1 / 3.0f);
}

TEST(Weave, AnyPositionIsAPlace) {
    const float huge = std::numeric_limits<float>::max(), nan = std::nanf("");
    for (const float x : {huge, -huge, nan, std::numeric_limits<float>::infinity(), -1e-9f}) {
        const WovenPlace place = locate_in_weave({5, 4, 2}, x, x);
        EXPECT_LE(std::abs(place.along), 1);
        EXPECT_LE(std::abs(place.across), 1);
    }
}

class BentYarnTest : public ::testing::Test {
  protected:
    const BentYarn straight_{Yarn{0.5f, 1, 0, 10, 0}}, twisted_{Yarn{0.5f, 1, 30, 10, 0}},
        flat_{Yarn{0.5f, 0.5f, 0, 10, 0}};
};

// An arc of height 1/2 over a chord of 2 begins at an angle of 2 atan(1/2).
TEST_F(BentYarnTest, NormalsLeanOutwardsOverTheBow) {
    const float largest = 2 * std::atan(0.5f);
    const YarnPoint end = straight_.at({true, 1, 0, 2}, 1, 1);
    EXPECT_LT((end.normal - Vec3(0, std::sin(largest), std::cos(largest))).length(), 1e-6f);
    EXPECT_LT((end.tangent - Vec3(0, std::cos(largest), -std::sin(largest))).length(), 1e-6f);
    const YarnPoint side = straight_.at({false, 0, -0.6f, 2}, 1, 1);
    EXPECT_LT((side.normal - Vec3(0, -0.6f, 0.8f)).length(), 1e-6f);
    EXPECT_NEAR(flat_.at({false, 0, -0.6f, 2}, 1, 1).normal.y, -0.3f, 1e-6f);
    // Where v grows the other way, so does the bow.
    const YarnPoint turned = straight_.at({true, 1, 0, 2}, 1, -1);
    EXPECT_LT((turned.normal - Vec3(0, -std::sin(largest), std::cos(largest))).length(), 1e-6f);
}

// A Z twist rises to the right, like the stroke of the letter, whichever way the yarn runs and the
// texture lies.
TEST_F(BentYarnTest, TwistIsThatOfTheLetter) {
    for (const float sense : {1.0f, -1.0f}) {
        const Vec3 warp = twisted_.at({true, 0, 0, 1}, 1, sense).tangent * sense;
        EXPECT_NEAR(warp.x, 0.5f, 1e-5f);
        EXPECT_NEAR(warp.y, std::sqrt(0.75f), 1e-5f);
    }
    const Vec3 weft = twisted_.at({false, 0, 0, 1}, 1, 1).tangent;
    EXPECT_NEAR(weft.x, std::sqrt(0.75f), 1e-5f);
    EXPECT_NEAR(weft.y, -0.5f, 1e-5f);
}

TEST_F(BentYarnTest, FibresLieInTheSurface) {
    for (int i = 0; i < 200; ++i) {
        const float along = std::sin(static_cast<float>(i)), across = std::cos(3.0f * i);
        const YarnPoint point = twisted_.at({i % 2 == 0, along, across, 1 + i % 4 * 1.0f}, 1, -1);
        EXPECT_NEAR(point.normal.length(), 1, 1e-5f);
        EXPECT_NEAR(point.tangent.length(), 1, 1e-5f);
        EXPECT_NEAR(point.normal.dot(point.tangent), 0, 1e-5f);
        EXPECT_GE(point.normal.z, 0);
    }
}

}  // namespace
}  // namespace lxs::shading::weave_test
