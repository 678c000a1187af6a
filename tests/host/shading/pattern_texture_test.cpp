// Textures that are deterministic patterns, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shading_fixture.h"

namespace lxs::pattern_texture_test {
namespace {

TexturePoint at_uv(float u, float v) {
    TexturePoint point;
    point.uv = {u, v};
    return point;
}
TexturePoint at(float x, float y, float z) {
    TexturePoint point;
    point.p = {x, y, z};
    return point;
}

class PatternTextureTest : public ::testing::Test {
  protected:
    /// Share of the box from 0 to `size` where a brick texture is 1.
    double brick_share(const std::vector<ParameterValue>& values, const Vec3& size) {
        const auto texture = scene_.make_float("brick", values);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> unit(0, 1);
        constexpr int kPoints = 40000;
        int inside = 0;
        for (int i = 0; i < kPoints; ++i) {
            const Vec3 p = Vec3(unit(random), unit(random), unit(random)) * size;
            inside += texture->evaluate(at(p.x, p.y, p.z)) == 1 ? 1 : 0;
        }
        return static_cast<double>(inside) / kPoints;
    }

    ShadingFixture scene_;
};

TEST_F(PatternTextureTest, BilerpIsLinearAlongEachCoordinateAndRepeats) {
    const auto floats = scene_.make_float(
        "bilerp", {number("v00", 1), number("v01", 2), number("v10", 4), number("v11", 8)});
    EXPECT_FLOAT_EQ(floats->evaluate(at_uv(0, 0)), 1);
    EXPECT_FLOAT_EQ(floats->evaluate(at_uv(0, 0.5f)), 1.5f);
    EXPECT_FLOAT_EQ(floats->evaluate(at_uv(0.5f, 0)), 2.5f);
    EXPECT_FLOAT_EQ(floats->evaluate(at_uv(0.5f, 0.5f)), 3.75f);
    EXPECT_FLOAT_EQ(floats->evaluate(at_uv(2.5f, -0.5f)), 3.75f);
    const auto colors = scene_.make_color("bilerp", {color("v11", {0, 0, 4})});
    EXPECT_FLOAT_EQ(colors->evaluate(at_uv(0.25f, 0.5f)).x, 0.375f);  // v01 is white
    EXPECT_FLOAT_EQ(colors->evaluate(at_uv(0.25f, 0.5f)).z, 0.375f + 0.5f);
}

TEST_F(PatternTextureTest, UvMaskShowsTheUnitSquare) {
    const auto mask = scene_.make_float("uvmask", {number("innertex", 3), number("outertex", 5)});
    EXPECT_EQ(mask->evaluate(at_uv(0.5f, 1)), 3);
    EXPECT_EQ(mask->evaluate(at_uv(0.5f, 1.001f)), 5);
    EXPECT_EQ(mask->evaluate(at_uv(-0.001f, 0.5f)), 5);
}

// A cell holds a dot of radius 0.35, whole, where the noise in its middle is above 0: in half of
// the cells but for those where it is 0, about a quarter.
TEST_F(PatternTextureTest, DotsCoverTheShareOfTheirCells) {
    const auto dots = scene_.make_float("dots", {number("inside", 0), number("outside", 1)});
    int cells_with_dots = 0;
    double covered = 0;
    constexpr int kCells = 40, kSteps = 20;
    for (int cell = 0; cell < kCells * kCells; ++cell) {
        int inside = 0;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const auto step = [](int k) { return (static_cast<float>(k) + 0.5f) / kSteps - 0.5f; };
            const int column = cell % kCells, row = cell / kCells;
            const float x = static_cast<float>(column) + step(i % kSteps);
            const float y = static_cast<float>(row) + step(i / kSteps);
            inside += dots->evaluate(at_uv(x, y)) == 1 ? 1 : 0;
        }
        covered += static_cast<double>(inside) / (kSteps * kSteps);
        cells_with_dots += inside > 0 ? 1 : 0;
    }
    EXPECT_NEAR(covered / cells_with_dots, 3.14159265 * 0.35 * 0.35, 0.01);
    EXPECT_NEAR(static_cast<double>(cells_with_dots) / (kCells * kCells), 0.375, 0.05);
}

// LuxRender shows "outside" in the dots, which cover 0.375 * pi * 0.35^2 of the plane, and "inside"
// between them; its defaults make black dots on white.
TEST_F(PatternTextureTest, DotsShowWhatIsNamedOutside) {
    const auto named = scene_.make_float("dots", {number("inside", 3), number("outside", 5)});
    const auto plain = scene_.make_float("dots");
    constexpr int kSteps = 500;
    int in_dots = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const int column = i % kSteps, row = i / kSteps;
        const float x = 0.08f * static_cast<float>(column), y = 0.08f * static_cast<float>(row);
        const float value = named->evaluate(at_uv(x, y));
        ASSERT_TRUE(value == 3 || value == 5);
        in_dots += value == 5 ? 1 : 0;
        ASSERT_EQ(plain->evaluate(at_uv(x, y)), value == 5 ? 0 : 1);
    }
    EXPECT_NEAR(in_dots / double(kSteps * kSteps), 0.375 * 3.14159265 * 0.35 * 0.35, 0.02);
}

// LuxRender's palette: radical inverses of 1, 7, 13, ... 91 in bases 2, 3 and 5.
TEST_F(PatternTextureTest, HarlequinGivesEachFaceOneOfLuxRendersColours) {
    const auto texture = scene_.make_color("harlequin");
    std::vector<Vec3> colours;
    for (std::uint32_t face = 0; face < 16; ++face) {
        TexturePoint point;
        point.face = face;
        colours.push_back(texture->evaluate(point));
        point.face += 48;
        EXPECT_EQ(texture->evaluate(point), colours.back()) << "the palette repeats";
    }
    const auto holds = [&](const Vec3& colour) {
        return std::any_of(colours.begin(), colours.end(),
                           [&](const Vec3& c) { return c.equalWithAbsError(colour, 1e-6f); });
    };
    EXPECT_TRUE(holds(Vec3(1 / 2.0f, 1 / 3.0f, 1 / 5.0f))) << "of 1";
    EXPECT_TRUE(holds(Vec3(7 / 8.0f, 5 / 9.0f, 11 / 25.0f))) << "of 7";
    EXPECT_TRUE(holds(Vec3(11 / 16.0f, 13 / 27.0f, 17 / 25.0f))) << "of 13: 1101, 111, 23";
    EXPECT_TRUE(holds(Vec3(109 / 128.0f, 91 / 243.0f, 43 / 125.0f)))
        << "of 91: 1011011, 10101, 331";
    for (std::size_t i = 0; i < colours.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_NE(colours[i], colours[k]) << i << " and " << k;
    }
}

TEST_F(PatternTextureTest, RunningBondsShiftRows) {
    const auto bricks = scene_.make_float(
        "brick", {text("brickbond", "running"), number("brickwidth", 3), number("brickheight", 1),
                  number("brickdepth", 1), number("mortarsize", 0.25), number("brickrun", 0.5),
                  number("bricktex", 1), number("mortartex", 0.5)});
    EXPECT_EQ(bricks->evaluate(at(0.1f, 0, 0.1f)), 1);
    EXPECT_EQ(bricks->evaluate(at(2.9f, 0, 0.1f)), 0.5f);  // joint before the next brick
    EXPECT_EQ(bricks->evaluate(at(0.1f, 0, 0.9f)), 0.5f);  // joint above
    EXPECT_EQ(bricks->evaluate(at(2.9f, 0, 1.1f)), 1);     // half a brick further
    EXPECT_EQ(bricks->evaluate(at(1.4f, 0, 1.1f)), 0.5f);
    EXPECT_EQ(bricks->evaluate(at(2.9f, 0, 2.1f)), 0.5f);
}

TEST_F(PatternTextureTest, ModulationIsAFactorOnBricksOnly) {
    const auto bricks = scene_.make_float(
        "brick", {number("bricktex", 0.5), number("brickmodtex", 0.25), number("mortartex", 0.75)});
    EXPECT_EQ(bricks->evaluate(at(0.1f, 0, 0.05f)), 0.125f);
    EXPECT_EQ(bricks->evaluate(at(0.1f, 0, 0.095f)), 0.75f);
}

// Volumes of bricks between joints of width m on the lower sides of boxes 2 x 1 x 1.
TEST_F(PatternTextureTest, EveryBondLeavesTheShareOfItsJoints) {
    const double m = 0.1, along = (2 - m) / 2, half = (1 - m) / 1, across = 1 - m;
    const auto share = [&](const char* bond) {
        // Whole periods of every bond: 3 and 5 along x, whole rows and columns elsewhere.
        return brick_share(
            {text("brickbond", bond), number("brickwidth", 2), number("brickheight", 1),
             number("brickdepth", 1), number("mortarsize", m), number("brickrun", 0.75),
             number("mortartex", 0)},
            {60, 60, 60});
    };
    const double error = 4 * 0.5 / std::sqrt(40000.0);  // 4 standard deviations at most
    EXPECT_NEAR(share("stacked"), along * across * across, error);
    EXPECT_NEAR(share("running"), along * across * across, error);
    EXPECT_NEAR(share("flemish"), (2 * along + half) / 3 * across * across, error);
    EXPECT_NEAR(share("english"), (along + half) / 2 * across * across, error);
    EXPECT_NEAR(share("chain link"), (4 * along + half) / 5 * across * across, error);
    EXPECT_NEAR(share("herringbone"), along * across * across, error);
    EXPECT_NEAR(share("basket"), along * across * across, error);
}

// A herringbone's bricks are whole: from inside one, a walk along it stays inside for its length.
TEST_F(PatternTextureTest, HerringboneLaysBricksBothWays) {
    const auto bricks =
        scene_.make_float("brick", {text("brickbond", "herringbone"), number("brickwidth", 2),
                                    number("brickdepth", 1), number("brickheight", 1),
                                    number("mortarsize", 0.01), number("mortartex", 0)});
    const auto crosses = [&](const Vec3& a, const Vec3& step) {
        const Vec3 b = a + step / 2;
        return bricks->evaluate(at(b.x, b.y, b.z)) == 0;
    };
    int along_x = 0, along_y = 0;
    for (int i = 0; i < 16; ++i) {
        // Steps from the middle of a cell to the next, half a joint off: on the border or within.
        const int x = i % 4, y = i / 4;
        const Vec3 middle(static_cast<float>(x) + 0.495f, static_cast<float>(y) + 0.495f, 0);
        along_x += crosses(middle, {1, 0, 0}) ? 0 : 1;
        along_y += crosses(middle, {0, 1, 0}) ? 0 : 1;
    }
    EXPECT_EQ(along_x, 4);  // half of the bricks, one inner border for two cells each
    EXPECT_EQ(along_y, 4);
}

TEST_F(PatternTextureTest, BricksWarnOfBevelsAndKnowTheirBonds) {
    scene_.make_float("brick", {number("brickbevel", 0)});
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    scene_.make_float("brick", {number("brickbevel", 0.01)});
    EXPECT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_THROW(scene_.make_color("brick", {text("brickbond", "british")}), InputError);
    EXPECT_THROW(scene_.make_color("brick", {number("brickwidth", 0)}), InputError);
}

TEST_F(PatternTextureTest, DensityGridIsTrilinear) {
    std::vector<ParameterValue> values{integer("nx", 2), numbers("density", {1, 3})};
    const auto value = [&](const char* wrap, float x) {
        std::vector<ParameterValue> all = values;
        all.push_back(text("wrap", wrap));
        return scene_.make_float("densitygrid", all)->evaluate(at(x, 0.5f, 0.5f));
    };
    EXPECT_FLOAT_EQ(value("repeat", 0.25f), 1);
    EXPECT_FLOAT_EQ(value("repeat", 0.5f), 2);
    EXPECT_FLOAT_EQ(value("repeat", 0.75f), 3);
    EXPECT_FLOAT_EQ(value("repeat", 1), 2);
    EXPECT_FLOAT_EQ(value("clamp", 1), 3);
    EXPECT_FLOAT_EQ(value("black", 1), 1.5f);
    EXPECT_FLOAT_EQ(value("white", 1), 2);
    EXPECT_FLOAT_EQ(value("black", 1e30f), 0);
    EXPECT_THROW(scene_.make_float("densitygrid", {integer("nx", 3), numbers("density", {1, 3})}),
                 InputError);
    values.push_back(flag("cut", true));
    EXPECT_FLOAT_EQ(value("clamp", 1), 3);
    EXPECT_FLOAT_EQ(value("clamp", 1.01f), 0);
    EXPECT_FLOAT_EQ(value("black", 0), 0.5f);
}

TEST_F(PatternTextureTest, DensityGridOfColours) {
    const auto grid = scene_.make_color(
        "densitygrid",
        {integer("ny", 2), colors("density", {1, 2, 3, 5, 6, 7}), text("wrap", "clamp")});
    EXPECT_EQ(grid->evaluate(at(0, 0, 0)), Rgb(1, 2, 3));
    EXPECT_EQ(grid->evaluate(at(0, 0.5f, 0)), Rgb(3, 4, 5));
    EXPECT_FLOAT_EQ(grid->cell_size(), 0.5f);
    EXPECT_THROW(scene_.make_color("densitygrid", {colors("density", {1, 2, 3, 5, 6, 7})}),
                 InputError);
}

/// Full below a height of 0, nothing above 1, within 0 and 1 in between.
TEST_F(PatternTextureTest, NoiseCloudEndsAboveItsBase) {
    const auto cloud = scene_.make_float("noisecloud");
    for (float x = 0.05f; x < 5; x += 0.37f) {
        EXPECT_EQ(cloud->evaluate(at(x, -0.01f, 0.3f)), 1);
        EXPECT_EQ(cloud->evaluate(at(x, 1, 0.3f)), 0);
        const float between = cloud->evaluate(at(x, 0.7f, 0.3f));
        EXPECT_GE(between, 0);
        EXPECT_LE(between, 1);
    }
}

TEST_F(PatternTextureTest, VertexColoursAreTheMeshs) {
    TexturePoint point;
    EXPECT_EQ(scene_.make_color("hitpointcolor")->evaluate(point), Rgb(1.0f));
    point.color = Rgb(0.25f, 0.5f, 0.75f);
    point.alpha = 0.125f;
    EXPECT_EQ(scene_.make_color("hitpointcolor")->evaluate(point), point.color);
    EXPECT_EQ(scene_.make_float("hitpointgrey")->evaluate(point), 0.5f);
    EXPECT_EQ(scene_.make_float("hitpointgrey", {integer("channel", 2)})->evaluate(point), 0.75f);
    EXPECT_EQ(scene_.make_float("hitpointalpha")->evaluate(point), 0.125f);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    EXPECT_THROW(scene_.make_float("hitpointgrey", {integer("channel", 3)}), InputError);
}

}  // namespace
}  // namespace lxs::pattern_texture_test
