// Protects the shared statistics of progressive photon mapping, by hand-made passes.
#include "aips/core/radii/ppm_statistics.h"

#include <gtest/gtest.h>

namespace aips::ppm_statistics_test {
namespace {

TEST(PpmStatistics, FollowsTheEquations) {
    const PpmStep first = ppm_step(0, 10, 0.7);  // N = 0, M = 10: the share kept is alpha
    EXPECT_DOUBLE_EQ(first.photons, 7);
    EXPECT_DOUBLE_EQ(first.share, 0.7);
    const PpmStep second = ppm_step(first.photons, 5, 0.7);
    EXPECT_DOUBLE_EQ(second.photons, 10.5);
    EXPECT_DOUBLE_EQ(second.share, (7 + 0.7 * 5) / 12);
}

TEST(PpmStatistics, APassWithoutPhotonsChangesNothing) {
    for (const double photons : {0.0, 3.5}) {
        const PpmStep step = ppm_step(photons, 0, 0.5);
        EXPECT_EQ(step.photons, photons);
        EXPECT_EQ(step.share, 1);
    }
}

TEST(PpmStatistics, AlphaOneKeepsTheRadius) {
    EXPECT_EQ(ppm_step(3, 4, 1).share, 1);
    EXPECT_EQ(ppm_step(3, 4, 1).photons, 7);
}

}  // namespace
}  // namespace aips::ppm_statistics_test
