// Protects the warps between the square, the hemisphere and the sphere: inverses and densities.
#include "aips/core/sampling/sampling.h"

#include <gtest/gtest.h>

#include <vector>

#include "aips/core/sampling/random.h"
#include "chi_square.h"

namespace aips::sampling_test {
namespace {

constexpr double kSignificance = 1e-4;
constexpr int kDraws = 100000;

Vec2 grid_point(int i, int j) {
    return {(float(i) + 0.5f) / 100, (float(j) + 0.25f) / 100};
}

TEST(Sampling, CosineSquareHasAnInverse) {
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const Vec2 u = grid_point(i, j);
            const Vec2 back = cosine_hemisphere_to_square(square_to_cosine_hemisphere(u));
            ASSERT_NEAR(back.x, u.x, 2e-6);
            ASSERT_NEAR(back.y, u.y, 2e-6);
        }
    }
}

TEST(Sampling, CylindricalSquareHasAnInverse) {
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const Vec2 u = grid_point(i, j);
            const Vec2 back = uniform_sphere_to_square(square_to_uniform_sphere(u));
            ASSERT_NEAR(back.x, u.x, 2e-6);
            ASSERT_NEAR(back.y, u.y, 2e-5);  // near the poles the angle loses digits
        }
    }
}

TEST(Sampling, InversesStayInTheHalfOpenSquare) {
    const Vec3 directions[] = {{1, 0, 0},        {-1, 0, 0},      {0, 1, 0},
                               {0, -1, 0},       {0, 0, 1},       {0, 0, -1},
                               {-1, -1e-12f, 0}, {1, -1e-12f, 0}, {-1, -0.0f, 0}};
    for (const Vec3 w : directions) {
        for (const Vec2 u : {cosine_hemisphere_to_square(w), uniform_sphere_to_square(w)}) {
            EXPECT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
        }
    }
    EXPECT_EQ(clamp_to_unit(std::nanf("")), 0.0f);
    EXPECT_LT(clamp_to_unit(1.0f), 1.0f);
}

TEST(Sampling, PolesDoNotDependOnTheSignOfZero) {
    EXPECT_EQ(uniform_sphere_to_square({0.0f, 0.0f, 1}),
              uniform_sphere_to_square({-0.0f, -0.0f, 1}));
}

// Directions by the warp fall in bands of z and sectors of angle as the stated density says; the
// inverse takes uniform directions to uniform points.
TEST(Sampling, WarpsHaveTheirDensities) {
    constexpr std::size_t kBands = 10;
    std::vector<double> sphere(kBands * kBands), cosine(kBands * kBands), inverse(kBands * kBands);
    RandomStream random(5, 0, 0, RandomDomain::Guide);
    const auto cell = [](double x) {
        return std::min(kBands - 1, std::size_t(std::max(0.0, x) * kBands));
    };
    for (int i = 0; i < kDraws; ++i) {
        const Vec3 w = square_to_uniform_sphere(random.next2());
        const double turn = std::atan2(w.y, w.x) / (2 * kPi) + 0.5;
        ++sphere[cell((w.z + 1) / 2.0) * kBands + cell(turn)];
        const Vec3 c = square_to_cosine_hemisphere(random.next2());
        const double c_turn = std::atan2(c.y, c.x) / (2 * kPi) + 0.5;
        ++cosine[cell(c.z * c.z) * kBands + cell(c_turn)];  // the density makes z^2 uniform
        const Vec2 back = cosine_hemisphere_to_square(c);
        ++inverse[cell(back.y) * kBands + cell(back.x)];
    }
    const std::vector<double> flat(kBands * kBands, double(kDraws) / (kBands * kBands));
    for (const auto& hits : {sphere, cosine, inverse}) {
        const auto result = test::chi_square(hits, flat);
        EXPECT_GT(result.p_value, test::sidak(kSignificance, 3)) << result.describe;
    }
}

TEST(Sampling, FramesAreOrthonormalAlsoAtThePoles) {
    RandomStream random(6, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 1000; ++i) {
        Vec3 n = square_to_uniform_sphere(random.next2());
        if (i == 0) n = {0, 0, 1};
        if (i == 1) n = {0, 0, -1};
        const Frame f(n);
        const Vec3 v{0.3f, -0.4f, 0.8f};
        const Vec3 back = f.to_local(f.to_world(v));
        ASSERT_NEAR(length(back - v), 0, 1e-5);
        ASSERT_NEAR(dot(cross(f.s, f.t), f.n), 1, 1e-5);
    }
}

}  // namespace
}  // namespace aips::sampling_test
