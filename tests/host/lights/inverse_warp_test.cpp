// Protects the inverses of the warps: round trips in both orders end where they began.
#include <gtest/gtest.h>

#include <cmath>

#include "light_cases.h"
#include "piecewise_2d.h"
#include "warp.h"

namespace lxs::test::inverse_warp_test {
namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;

/// Calls `check` for a grid with the unit square's border and for random points.
template <class Check>
void over_unit_square(Check&& check) {
    constexpr int kGrid = 16;
    for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
            const auto at = [](int k) {
                return std::min(static_cast<float>(k) / static_cast<float>(kGrid), kBelowOne);
            };
            check(Vec2(at(i), at(j)));
        }
    }
    Random random(67);
    for (int i = 0; i < 20000; ++i)
        check(Vec2(random(), random()));
}

void expect_in_unit_square(const Vec2& u) {
    EXPECT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1) << u;
}

TEST(InverseWarp, Disk) {
    over_unit_square([](const Vec2& u) {
        const Vec2 back = concentric_disk_to_square(square_to_concentric_disk(u));
        expect_in_unit_square(back);
        EXPECT_LT((back - u).length(), 1e-6f) << u;
    });
    expect_in_unit_square(concentric_disk_to_square(Vec2(3, -2)));
}

TEST(InverseWarp, CosineHemisphere) {
    over_unit_square([](const Vec2& u) {
        const Vec2 back = cosine_hemisphere_to_square(square_to_cosine_hemisphere(u));
        EXPECT_LT((back - u).length(), 1e-6f) << u;
    });
}

/// Compared as directions: the azimuth means nothing at the poles, and wraps around.
TEST(InverseWarp, Sphere) {
    over_unit_square([](const Vec2& u) {
        const Vec3 w = uniform_sphere(double(u.x), u.y);
        const Vec2 back(from_uniform_sphere(w));
        expect_in_unit_square(back);
        EXPECT_NEAR(back.x, u.x, 1e-6f);
        EXPECT_LT((uniform_sphere(double(back.x), back.y) - w).length(), 1e-3f) << u;
    });
}

/// At both poles: directions closer than floats below 1 tell apart.
TEST(InverseWarp, PolesOfTheSphere) {
    for (const float z : {1.0f, -1.0f}) {
        for (float sine = 1e-5f; sine < 1e-2f; sine *= 1.3f) {
            const Vec3 w(sine, 0, z * std::sqrt(1 - sine * sine));
            const Imath::V2d u = from_uniform_sphere(w);
            const Vec3 back = uniform_sphere(u.x, static_cast<float>(u.y));
            EXPECT_NEAR(back.x / sine, 1, 1e-5f) << sine;
            EXPECT_NEAR(back.z, w.z, 0x1p-23f);
        }
    }
}

/// A cone of the sun's size, in which cosines have no digits left.
TEST(InverseWarp, NarrowCone) {
    constexpr float kExtent = 1e-5f;
    over_unit_square([](const Vec2& u) {
        const Vec3 w = around_z(u.x * kExtent, u.y);
        const Vec2 back = from_around_z(w);
        EXPECT_NEAR(back.x / kExtent, u.x, 1e-5f);
        EXPECT_LT((around_z(back.x, back.y) - w).length(), 1e-5f * std::sqrt(2 * kExtent));
    });
}

TEST(InverseWarp, Triangle) {
    over_unit_square([](const Vec2& u) {
        const Vec2 back = from_uniform_triangle(uniform_triangle(u.x, u.y));
        expect_in_unit_square(back);
        EXPECT_LT((back - u).length(), 1e-6f) << u;
    });
}

TEST(InverseWarp, Interval) {
    for (const float share : {0.0f, 0.3f, 1.0f}) {
        const float u = within_interval(0.25f, 0.75f, share);
        EXPECT_TRUE(u >= 0.25f && u < 0.75f);
        EXPECT_NEAR(u, 0.25f + 0.5f * share, 1e-6f);
    }
    const float next = std::nextafter(0.25f, 1.0f);
    EXPECT_EQ(within_interval(0.25f, next, 1.0f), 0.25f);
    EXPECT_LT(within_interval(0.5f, 1.0f, 1.0f), 1.0f);
}

/// Weights over four decades, with empty cells, an empty row and an empty column.
TEST(InverseWarp, PiecewiseConstantDensity) {
    constexpr std::size_t kWidth = 13, kHeight = 7;
    std::vector<float> weights(kWidth * kHeight);
    Random random(71);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::size_t x = i % kWidth, y = i / kWidth;
        const bool empty = x == 4 || y == 2 || i % 5 == 0;
        weights[i] = empty ? 0.0f : std::pow(10.0f, -4 * random());
    }
    const Piecewise2D map(kWidth, kHeight, weights);
    over_unit_square([&](const Vec2& u) {
        float density = 0;
        const Vec2 p = map.sample(u, density);
        Vec2 back;
        // Rounding may put a point at a cell's edge into its empty neighbour.
        const Vec2 cell(p.x * kWidth, p.y * kHeight);
        const auto at_edge = [](float x) { return std::abs(x - std::round(x)) < 1e-5f; };
        if (at_edge(cell.x) || at_edge(cell.y)) return;
        ASSERT_TRUE(map.coordinates(p, back));
        expect_in_unit_square(back);
        EXPECT_LT((back - u).length(), 1e-5f) << u;
        EXPECT_LT((map.sample(back, density) - p).length(), 1e-2f);
    });
    Vec2 u;
    EXPECT_FALSE(map.coordinates(Vec2(4.5f / kWidth, 0.1f), u)) << "empty column";
    EXPECT_FALSE(map.coordinates(Vec2(0.1f, 2.5f / kHeight), u)) << "empty row";
    EXPECT_FALSE(Piecewise2D().coordinates(Vec2(0.5f), u)) << "nothing to draw";
}

}  // namespace
}  // namespace lxs::test::inverse_warp_test
