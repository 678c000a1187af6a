// Protects the radius schedule: the recursion, large counts, monotony, floors, bad arguments.
#include "aips/core/radii/radius_schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace aips::radius_schedule_test {
namespace {

constexpr double kReference = 100000;

TEST(RadiusSchedule, IsTheRecursionAtWholePasses) {
    for (const double alpha : {0.1, 0.5, 2.0 / 3.0, 0.7, 1.0}) {
        double squared = 1;
        for (int i = 1; i <= 10000; ++i) {
            const float r = knaus_zwicker_radius(1, (i - 1) * kReference, kReference, alpha);
            ASSERT_NEAR(r / std::sqrt(squared), 1, 1e-6) << "pass " << i << " alpha " << alpha;
            squared *= (i + alpha) / (i + 1);
        }
    }
}

TEST(RadiusSchedule, StartsAtTheInitialRadiusAndDependsOnPhotonsOnly) {
    EXPECT_EQ(knaus_zwicker_radius(0.25, 0, kReference, 0.7), 0.25f);
    EXPECT_EQ(knaus_zwicker_radius(1, 3e6, 1e5, 0.7), knaus_zwicker_radius(1, 3e7, 1e6, 0.7));
}

TEST(RadiusSchedule, FallsMonotonouslyAlsoBetweenPasses) {
    float last = std::numeric_limits<float>::infinity();
    for (double shot = 0; shot < 1e13; shot = shot * 1.01 + 1000) {
        const float r = knaus_zwicker_radius(1, shot, kReference, 0.7);
        ASSERT_LE(r, last) << shot;
        last = r;
    }
}

// Asymptotically r^2 = n^(alpha - 1) / Gamma(1 + alpha); a difference of lgamma would be off by
// 1e-3 at n = 1e12.
TEST(RadiusSchedule, KeepsItsDigitsAtLargeCounts) {
    for (const double n : {1e6, 1e9, 1e12}) {
        const double squared = std::pow(n, -0.3) / std::tgamma(1.7);
        const float r = knaus_zwicker_radius(1, (n - 1) * 1e5, 1e5, 0.7);
        EXPECT_NEAR(r / std::sqrt(squared), 1, 1e-6);
    }
}

TEST(RadiusSchedule, AlphaOneKeepsTheRadius) {
    EXPECT_EQ(knaus_zwicker_radius(0.5, 1e12, 1e3, 1.0), 0.5f);
}

TEST(RadiusSchedule, RespectsTheFloor) {
    EXPECT_EQ(knaus_zwicker_radius(1, 1e15, 1, 0.1, 0.125), 0.125f);
    EXPECT_EQ(knaus_zwicker_radius(0.1, 0, 1, 0.5, 5.0), 0.1f);
    EXPECT_TRUE(std::isnormal(knaus_zwicker_radius(1e-30, 1e300, 1, 0.0, 0.0)));
}

TEST(RadiusSchedule, BadArgumentsGiveAFinitePositiveRadius) {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double a : {nan, inf, -inf, -1.0, 0.0, 1e300}) {
        for (const double b : {nan, inf, -1.0, 0.0, 1e5}) {
            for (const double alpha : {nan, -1.0, 0.7, 2.0}) {
                for (const float r :
                     {knaus_zwicker_radius(a, b, 1e5, alpha), knaus_zwicker_radius(1, a, b, alpha),
                      knaus_zwicker_radius(1, 1e5, a, alpha, b)}) {
                    ASSERT_TRUE(std::isfinite(r) && r > 0) << a << ' ' << b << ' ' << alpha;
                }
            }
        }
    }
}

}  // namespace
}  // namespace aips::radius_schedule_test
