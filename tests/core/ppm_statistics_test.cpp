// Protects the shared statistics of progressive photon mapping, by hand-made passes.
#include "aips/core/ppm_statistics.h"

#include <gtest/gtest.h>

#include <limits>

namespace aips {
namespace {

TEST(PpmStatistics, FollowsTheEquations) {
    PpmStatistics s(2.0f);
    for (int i = 0; i < 10; ++i)
        s.add({1, 2, 3});
    s.end_pass(0.7f);  // N = 0, M = 10: the share kept is alpha
    EXPECT_NEAR(s.photons(), 7, 1e-5);
    EXPECT_NEAR(s.radius(), 2 * std::sqrt(0.7f), 1e-6);
    EXPECT_NEAR(s.flux().g, 20 * 0.7f, 1e-5);
    for (int i = 0; i < 5; ++i)
        s.add({1, 1, 1});
    s.end_pass(0.7f);
    const double share = (7 + 0.7 * 5) / 12;
    EXPECT_NEAR(s.photons(), 10.5, 1e-5);
    EXPECT_NEAR(s.radius(), 2 * std::sqrt(0.7 * share), 1e-6);
    EXPECT_NEAR(s.flux().r, (7 + 5) * share, 1e-5);
}

// Photons on the wrong side of a thin wall must not shrink the radius.
TEST(PpmStatistics, RejectedPhotonsCountForNothing) {
    PpmStatistics with(1.0f), without(1.0f);
    for (int i = 0; i < 4; ++i) {
        with.add({1, 0, 0});
        without.add({1, 0, 0});
        for (int k = 0; k < 100; ++k)
            with.add({});
        with.add({std::numeric_limits<float>::quiet_NaN(), 0, 0});
        with.add({-1, 0, 0});
        with.end_pass(0.7f);
        without.end_pass(0.7f);
    }
    EXPECT_EQ(with.radius(), without.radius());
    EXPECT_EQ(with.photons(), without.photons());
    EXPECT_EQ(with.flux(), without.flux());
}

TEST(PpmStatistics, APassWithoutPhotonsChangesNothing) {
    PpmStatistics s(3.0f);
    s.end_pass(0.5f);
    EXPECT_EQ(s.radius(), 3.0f);
    EXPECT_EQ(s.photons(), 0);
}

}  // namespace
}  // namespace aips
