// Protects the means of present photon paths: what a guide has made of scores since it began to
// learn must not be hidden by what they were before.
#include "guides/adaptive/path_means.h"

#include <gtest/gtest.h>

namespace aips::path_means_test {
namespace {

void shoot(PathMeans& means, int paths, double score, double cost) {
    constexpr int kIteration = 1000;
    for (int i = 0; i < paths; ++i) {
        means.add(score, cost);
        if (i % kIteration == kIteration - 1) means.update(kIteration);
    }
}

TEST(PathMeans, NothingBeforeAPathWasWorthSomething) {
    PathMeans means;
    EXPECT_EQ(means.cost_over_score(), 0);
    EXPECT_EQ(means.score_times_cost(), 0);
    means.update(0);
    shoot(means, 2000, 0, 3);
    EXPECT_EQ(means.cost_over_score(), 0);
    EXPECT_EQ(means.score_times_cost(), 0);
}

TEST(PathMeans, OfEqualPaths) {
    PathMeans means;
    shoot(means, 50000, 5, 3);
    EXPECT_NEAR(means.cost_over_score(), 0.6, 1e-12);
    EXPECT_NEAR(means.score_times_cost(), 15, 1e-12);
}

// While the first fifth of the paths was unguided, scores were a thousand times as high.
TEST(PathMeans, PathsBeforeTheGuideLearnedAreForgotten) {
    PathMeans means;
    shoot(means, 20000, 1000, 3);
    shoot(means, 80000, 1, 3);
    // (1 / 5)^4 of 1000 each is what is left of them.
    EXPECT_LT(means.score_times_cost(), 3 * 3.0);
    shoot(means, 900000, 1, 3);
    EXPECT_NEAR(means.score_times_cost(), 3, 0.01);
}

}  // namespace
}  // namespace aips::path_means_test
