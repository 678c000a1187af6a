// Protects: what counts photons goes on counting, and means what it did, past 2^32 and 2^53.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "aips/core/chains/mutation.h"
#include "aips/core/chains/visibility_chain.h"
#include "aips/core/radii/ppm_statistics.h"
#include "aips/core/radii/radius_schedule.h"
#include "aips/core/trees/kd_tree.h"
#include "stress_case.h"

namespace counters_test {
namespace {

using namespace aips;
using namespace stress;

constexpr std::uint64_t kOne = 1, kTwoTo32 = kOne << 32, kTwoTo53 = kOne << 53;

TEST(StressCounters, OfANodesPhotons) {
    for (const std::uint64_t before : {kTwoTo32 - 1, kTwoTo53 - 1, kOne << 62}) {
        ValueStatistics powers;
        powers.count = before;
        powers.mean = 1;
        powers.squared_deviations = double(before);
        for (int i = 0; i < 1000; ++i)
            powers.add(i % 2 ? 0 : 2);
        EXPECT_EQ(powers.count, before + 1000);
        EXPECT_NEAR(powers.mean, 1, 1e-6);
        EXPECT_NEAR(powers.squared_deviations / double(powers.count), 1, 1e-6);
    }
    NodeTree tree({{0, 0, 0}, {1, 1, 1}}, {});
    tree.add_eye_rays(std::vector<Vec3>(1000, Vec3{0.5f, 0.5f, 0.5f}), kTwoTo53);
    EXPECT_DOUBLE_EQ(tree.node(0).weight, 1000 / double(kTwoTo53));
    record("a node's count, mean and variance from 2^32, 2^53, 2^62 photons on",
           "counts exact, mean and variance kept");
}

TEST(StressCounters, OfPpmStatistics) {
    for (const double before : {double(kTwoTo32), double(kTwoTo53), 0x1p62}) {
        for (const std::uint64_t more : {kOne, kTwoTo32, kTwoTo53}) {
            const PpmStep step = ppm_step(before, more, 0.7);
            EXPECT_GE(step.photons, before);
            EXPECT_GT(step.share, 0.7);
            EXPECT_LE(step.share, 1);
            const double lost = 0.3 * double(more) / (before + double(more));
            EXPECT_NEAR(step.share, 1 - lost, 2e-16);
        }
    }
    record("2^32 to 2^62 photons kept, 1 to 2^53 new ones", "share right to 2e-16");
}

TEST(StressCounters, OfTheRadiusSchedule) {
    float last = 1;
    double worst = 0;
    for (std::uint64_t paths = 1; paths < (kOne << 63); paths *= 2) {
        const float radius = knaus_zwicker_radius(1, double(paths), 1e6, 0.7);
        ASSERT_LE(radius, last);
        ASSERT_TRUE(std::isnormal(radius));
        last = radius;
        if (paths < (kOne << 40)) continue;
        // About n^(alpha - 1) / Gamma(1 + alpha) for the square.
        const double n = double(paths) / 1e6;
        const double far = std::sqrt(std::pow(n, -0.3) / std::tgamma(1.7));
        worst = std::max(worst, std::abs(double(radius) / far - 1));
    }
    EXPECT_LE(worst, 1e-5);
    record("1 to 2^62 photon paths",
           "radius falls on; off its asymptote by " + std::to_string(worst) + " of at most 1e-5");
}

TEST(StressCounters, OfMutations) {
    MutationSize size;
    size.learn(0.5, kTwoTo32);
    size.learn(0.5, kTwoTo53);
    const double before = size.size();
    size.learn(0, 3 * kTwoTo53);  // as many again, all refused
    EXPECT_EQ(size.steps(), kTwoTo32 + 4 * kTwoTo53);
    EXPECT_LT(size.size(), before - 0.1);
    EXPECT_GE(size.size(), MutationSize::kFloor);
    record("mutations of 2^32, 2^53, 2^55 steps", "counted exactly, their size still learns");
}

/// A pass of 2^33 steps, of which all but a few are measured: the numbers that address randomness.
TEST(StressCounters, OfChains) {
    VisibilityChain<int> chain;
    chain.begin_pass(kTwoTo53 + 1);
    ChainCounts counts, total;
    total.uniform = total.measured = kTwoTo32 - 5;
    chain.run(
        {1, kTwoTo32 + 7, 3, 64}, 10, 2,
        [](PrimaryPath& path, int&, std::uint64_t) { return path.start()[0] < 0.5; },
        [](int, std::uint32_t) {}, counts);
    total += counts;
    EXPECT_EQ(total.uniform, kTwoTo32 - 5 + counts.uniform);
    EXPECT_EQ(counts.measured, counts.uniform);
    EXPECT_EQ(counts.uniform + counts.mutated, 10u);
    record("a chain that measures 2^53 + 1 paths in pass 2^32 + 7", "counts exact");
}

}  // namespace
}  // namespace counters_test
