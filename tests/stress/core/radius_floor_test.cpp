// Protects: radii stay normal numbers, positive and above their floor, however many passes shrink
// them. A radius of 0 or a denormal one would make 1 / (pi r^2) infinite.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "aips/core/radii/radius_schedule.h"
#include "stress_case.h"

namespace radius_floor_test {
namespace {

TEST(StressRadius, TenThousandPassesKeepTheFloor) {
    constexpr double kFirst = 1, kFloor = 0.02, kPathsPerPass = 1e6;
    float radius = float(kFirst), before = radius;
    for (int pass = 0; pass < 10000; ++pass) {
        radius =
            aips::knaus_zwicker_radius(kFirst, pass * kPathsPerPass, kPathsPerPass, 0.1, kFloor);
        ASSERT_TRUE(std::isnormal(radius));
        ASSERT_GE(radius, float(kFloor));
        ASSERT_LE(radius, before);
        before = radius;
    }
    EXPECT_EQ(radius, float(kFloor));
    stress::record("10,000 passes of 1e6 paths, alpha 0.1, floor at 0.02 of the first radius",
                   "last radius " + std::to_string(radius));
}

}  // namespace
}  // namespace radius_floor_test
