// Protects the chains of Metropolis sampling, away from light transport: the image of a function
// known on paper is right in expectation from the first mutation on, whatever the settings that may
// only change variance.
#include "path/metropolis_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "block_test.h"
#include "metropolis_landscape.h"

namespace lxs::test::metropolis_chain_test {
namespace {

constexpr std::uint32_t kSize = kLandscapeSize;
constexpr std::size_t kPixels = std::size_t{kSize} * kSize;

/// Student tests of every pixel and the mean against the closed form over independent chains,
/// at a family-wise significance of 1e-3 (Sidak).
bool agrees(const ChainRun& run, const std::string& name) {
    constexpr int kChains = 160;
    std::vector<std::vector<double>> images;
    for (std::uint64_t seed = 1; seed <= kChains; ++seed) {
        images.push_back(image_of(run, seed));
        double sum = 0;
        for (const double pixel : images.back())
            sum += pixel / (kSize * kSize);
        images.back().push_back(sum);
    }
    double smallest = 1, detectable = 0;
    for (std::size_t k = 0; k <= kPixels; ++k) {
        const double expected = k == kPixels
                                    ? landscape_mean()
                                    : landscape_height(static_cast<std::uint32_t>(k % kSize),
                                                       static_cast<std::uint32_t>(k / kSize));
        double mean = 0, squares = 0;
        for (const auto& image : images)
            mean += image[k] / kChains;
        for (const auto& image : images)
            squares += (image[k] - mean) * (image[k] - mean);
        // Without large steps the mean of all pixels is exact: only rounding of floats is left.
        const double error =
            std::hypot(std::sqrt(squares / (kChains - 1) / kChains), 1e-6 * expected);
        if (expected == 0) {
            EXPECT_EQ(mean, 0) << "light in a black pixel";
            continue;
        }
        if (k == kPixels) detectable = 5 * error / expected;
        smallest =
            std::min(smallest, statistics::student_p((mean - expected) / error, kChains - 1));
    }
    const double threshold = 1 - std::pow(1 - 1e-3, 1.0 / (kSize * kSize + 1));
    std::cout << name << ": smallest p " << smallest << " (threshold " << threshold
              << "), a difference of the mean by " << 100 * detectable << " % would be found\n";
    return smallest > threshold;
}

TEST(MetropolisChain, EstimatesTheFunctionWithAnyShareOfLargeSteps) {
    for (const double large : {0.0, 0.1, 0.4, 1.0}) {
        ChainRun run;
        run.settings = {.large_probability = large, .max_consecutive_rejects = 0};
        EXPECT_TRUE(agrees(run, "large steps " + std::to_string(large)));
    }
}

TEST(MetropolisChain, PoorGuessOfTheMeanChangesNoExpectation) {
    for (const double factor : {0.1, 10.0}) {
        ChainRun run;
        run.settings.max_consecutive_rejects = 0;
        run.guess *= factor;
        EXPECT_TRUE(agrees(run, "guess times " + std::to_string(factor)));
    }
}

TEST(MetropolisChain, AnyRangeOnTheFilmGivesTheSameMean) {
    for (const double pixels : {0.05, 7.0, 100.0}) {
        ChainRun run;
        run.settings = {.max_consecutive_rejects = 0, .film_range = pixels};
        EXPECT_TRUE(agrees(run, "mutation range " + std::to_string(pixels)));
    }
}

// One chain's first two mutations are as right as its last: there is no start-up bias to wait for.
TEST(MetropolisChain, IsRightFromTheFirstMutation) {
    ChainRun run;
    run.mutations = 2;
    double sum = 0, squares = 0;
    constexpr int kChains = 40000;
    for (std::uint64_t seed = 1; seed <= kChains; ++seed) {
        double mean = 0;
        for (const double pixel : image_of(run, seed))
            mean += pixel / (kSize * kSize);
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / kChains;
    const double error = std::sqrt((squares / kChains - mean * mean) / kChains);
    EXPECT_LT(std::abs(mean - landscape_mean()), 4.5 * error);
    EXPECT_LT(error, 0.01 * landscape_mean());
}

// Shows that the test above has teeth.
TEST(MetropolisChain, ForcedAcceptanceBiasesAndIsCounted) {
    ChainRun run;
    run.settings.max_consecutive_rejects = 1;
    EXPECT_FALSE(agrees(run, "forced after 1 rejection"));
    ChainCounts counts;
    image_of(run, 1, &counts);
    EXPECT_GT(counts.forced, 0u);
    EXPECT_LT(counts.forced, counts.accepted);
}

TEST(MetropolisChain, CountsWhatItDid) {
    ChainRun run;
    ChainCounts counts;
    run.mutations = 20000;
    image_of(run, 9, &counts);
    EXPECT_EQ(counts.mutations, 20000u);
    // 8000 expected, standard deviation 69.
    EXPECT_NEAR(static_cast<double>(counts.large), 8000, 350);
    EXPECT_GT(counts.accepted, counts.accepted_large);
    EXPECT_GT(counts.accepted_large, 0u);
    // Large steps are plain samples: their mean is b; the peak makes the standard error 6 %.
    EXPECT_NEAR(counts.large_brightness / static_cast<double>(counts.large) / landscape_mean(), 1,
                0.3);
}

// With large steps alone and no share for the chain, splats are the plain samples themselves.
TEST(MetropolisChain, LargeStepsAloneArePlainMonteCarlo) {
    const MetropolisSettings settings{.large_probability = 1, .max_consecutive_rejects = 0};
    constexpr std::uint64_t kMutations = 500;
    Landscape landscape;
    MetropolisChain chain(settings, kSize, kSize, 4, 3);
    start_fairly(chain, 4);
    std::vector<Vec2> positions(kMutations + 1);
    std::vector<Rgb> radiance(kMutations + 1);
    SplatList splats{positions, radiance};
    std::vector<LitSample> lit;
    chain.run(kMutations, 1e30, landscape, splats, lit);
    std::vector<std::pair<float, float>> drawn, expected;
    for (std::size_t i = 0; i < splats.used; ++i) {
        if (radiance[i].x > 1e-20f) drawn.emplace_back(positions[i].x, radiance[i].x);
    }
    std::size_t next_lit = 0;
    for (std::uint64_t i = 0; i < kMutations; ++i) {
        RandomStream sample = chain.plain_sample(i);
        Contribution contribution;
        landscape.evaluate(sample, contribution);
        if (contribution.brightness > 0)
            expected.emplace_back(contribution.position.x, contribution.radiance[0].x);
        if (contribution.brightness > 0 && next_lit < lit.size()) {
            EXPECT_EQ(lit[next_lit].mutation, i);
            EXPECT_EQ(lit[next_lit++].brightness, contribution.brightness);
        }
    }
    EXPECT_EQ(next_lit, lit.size());
    EXPECT_EQ(lit.size(), expected.size());
    std::sort(drawn.begin(), drawn.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(drawn, expected);
}

}  // namespace
}  // namespace lxs::test::metropolis_chain_test
