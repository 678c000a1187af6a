// Protects the chains of Metropolis sampling, away from light transport: mutations are as likely as
// their reverse, and the image of a function known on paper is right in expectation from the first
// mutation on, whatever the settings that may only change variance.
#include "path/metropolis_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <iostream>

#include "block_test.h"

namespace lxs::test {
namespace {

constexpr std::uint32_t kSize = 8;  ///< of the film, pixels

double chi_square_p(double statistic, double degrees) {
    return cdf(complement(boost::math::chi_squared(degrees), statistic));
}

// Signed lengths are even in sign and log-uniform in size: P(d > x) = log(largest / x) /
// log(ratio). Chi-square over 2 x 16 equally likely cells, significance 1e-4 each, fixed seed. A
// mutation from 0.999 goes around the end.
TEST(MetropolisMutation, IsSymmetricAndExponential) {
    const MutationRange range{1.0 / 1024, 1.0 / 64};
    for (const float from : {0.5f, 0.0f, 0.999f}) {
        std::array<int, 32> counts{};
        constexpr int kDraws = 64000;
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const float to = mutate(from, RandomStream(3, 0, i).next(), range);
            ASSERT_GE(to, 0.0f);
            ASSERT_LT(to, 1.0f);
            double moved = double{to} - from;
            moved -= std::round(moved);
            // Rounding to float may lift a length over the bounds by one part in 10^4.
            const double share = std::log(range.largest / std::abs(moved)) /
                                 std::log(range.largest / range.smallest);
            const int cell = std::clamp(static_cast<int>(share * 16), 0, 15);
            ++counts[static_cast<std::size_t>(moved > 0 ? cell : 16 + cell)];
        }
        double statistic = 0;
        for (const int count : counts)
            statistic += std::pow(count - kDraws / 32.0, 2) / (kDraws / 32.0);
        EXPECT_GT(chi_square_p(statistic, 31), 1e-4) << "from " << from;
    }
}

TEST(MetropolisMutation, StaysBelowOne) {
    EXPECT_LT(mutate(0.0f, 0.5f, {1e-9, 1e-9}), 1.0f);
    EXPECT_GE(mutate(0.3f, 0.2f, {0.1, 70.0}), 0.0f);
}

std::array<float, 6> read(MetropolisCoordinates& coordinates) {
    std::array<float, 6> values;
    for (float& value : values)
        value = coordinates.next();
    return values;
}

TEST(MetropolisCoordinates, SmallMutationsStartFromWhatWasAcceptedLast) {
    MetropolisCoordinates coordinates({1e-4, 1e-3}, {1e-4, 1e-3});
    const auto near = [](const auto& a, const auto& b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double moved = double{a[i]} - b[i];
            if (std::abs(moved - std::round(moved)) > (i < 2 ? 1e-3 : 1.0 / 64) + 1e-6)
                return false;
        }
        return true;
    };
    coordinates.propose(RandomStream(1, 0, 0), true);
    const auto first = read(coordinates);
    coordinates.accept();
    coordinates.propose(RandomStream(1, 1, 0), true);
    EXPECT_FALSE(near(read(coordinates), first)) << "a large step draws anew";
    coordinates.propose(RandomStream(1, 2, 0), false);
    const auto third = read(coordinates);
    EXPECT_TRUE(near(third, first)) << "the large step was not accepted";
    EXPECT_NE(third, first);
    coordinates.accept();
    coordinates.propose(RandomStream(1, 3, 0), false);
    EXPECT_TRUE(near(read(coordinates), third));
}

TEST(MetropolisCoordinates, EndlessPathsAreServed) {
    MetropolisCoordinates coordinates({}, {});
    for (std::uint64_t i = 0; i < 3; ++i) {
        coordinates.propose(RandomStream(1, i, 0), i == 0);
        double sum = 0;
        for (std::size_t k = 0; k < 3 * MetropolisCoordinates::kMostStored; ++k)
            sum += coordinates.next();
        EXPECT_NEAR(sum / (3 * MetropolisCoordinates::kMostStored), 0.5, 0.05);
        coordinates.accept();
    }
}

/// Brightness by pixel, from 0 to a peak of a hundred times the mean; in the left half of the film
/// it depends on five more coordinates, so that moves change the number of those in use.
double height_of(std::uint32_t x, std::uint32_t y) {
    if (x == 5 && y == 2) return 100;
    if (y == 7) return 0;
    return 0.2 + 0.1 * x * y;
}

class Landscape : public MetropolisTarget {
  public:
    void evaluate(PrimarySample& sample, Contribution& contribution) override {
        const Vec2 p = sample.next_2d();
        contribution.position = p * static_cast<float>(kSize);
        const auto x = static_cast<std::uint32_t>(contribution.position.x);
        const auto y = static_cast<std::uint32_t>(contribution.position.y);
        double value = height_of(x, y);
        if (x < kSize / 2) {
            for (int i = 0; i < 4; ++i)
                sample.next();
            value *= 2 * sample.next();  // a factor of mean 1
        }
        contribution.radiance.assign(1, Rgb(static_cast<float>(value)));
        contribution.brightness = value;
    }
};

constexpr double kHighest = 100;

double true_mean() {
    double sum = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x)
            sum += height_of(x, y) / (kSize * kSize);
    }
    return sum;
}

struct ChainRun {
    MetropolisSettings settings;
    double guess = true_mean();
    std::uint64_t mutations = 3000;
};

/// Starts a chain at a point drawn in proportion to brightness, by rejection.
void start_fairly(MetropolisChain& chain, std::uint64_t seed) {
    Landscape landscape;
    Contribution contribution;
    for (std::uint64_t i = 0;; ++i) {
        const RandomStream stream(seed, i, 0, RandomDomain::MetropolisSeeds);
        RandomStream sample = stream;
        landscape.evaluate(sample, contribution);
        RandomStream coin(seed, i, 1, RandomDomain::MetropolisSeeds);
        if (kHighest * coin.next() < contribution.brightness) return chain.start(stream, landscape);
    }
}

/// Mean per pixel of the splats of one chain: an unbiased estimate of the landscape.
std::vector<double> image_of(const ChainRun& run, std::uint64_t seed,
                             ChainCounts* counts = nullptr) {
    Landscape landscape;
    MetropolisChain chain(run.settings, kSize, kSize, seed, 0);
    start_fairly(chain, seed);
    std::vector<Vec2> positions(run.mutations + 1);
    std::vector<Rgb> radiance(run.mutations + 1);
    SplatList splats{positions, radiance};
    const ChainCounts done = chain.run(run.mutations, {run.guess, true_mean()}, landscape, splats);
    if (counts != nullptr) *counts = done;
    std::vector<double> image(kSize * kSize);
    for (std::size_t i = 0; i < splats.used; ++i) {
        const auto pixel = static_cast<std::size_t>(positions[i].y) * kSize +
                           static_cast<std::size_t>(positions[i].x);
        image[pixel] += radiance[i].x * double{kSize * kSize} / double(run.mutations);
    }
    return image;
}

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
    for (std::size_t k = 0; k <= kSize * kSize; ++k) {
        const double expected = k == kSize * kSize
                                    ? true_mean()
                                    : height_of(static_cast<std::uint32_t>(k % kSize),
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
        if (k == kSize * kSize) detectable = 5 * error / expected;
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
    EXPECT_LT(std::abs(mean - true_mean()), 4.5 * error);
    EXPECT_LT(error, 0.01 * true_mean());
}

// Shows that the test above has teeth, and that the default of maxconsecrejects doesn't bite here.
TEST(MetropolisChain, ForcedAcceptanceBiasesAndIsCounted) {
    ChainRun run;
    run.settings.max_consecutive_rejects = 1;
    EXPECT_FALSE(agrees(run, "forced after 1 rejection"));
    ChainCounts counts;
    image_of(run, 1, &counts);
    EXPECT_GT(counts.forced, 0u);
    EXPECT_LT(counts.forced, counts.accepted);
    run.settings = {};
    EXPECT_TRUE(agrees(run, "defaults"));
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
    EXPECT_NEAR(counts.large_brightness / static_cast<double>(counts.large) / true_mean(), 1, 0.3);
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
    chain.run(kMutations, {1e30, true_mean()}, landscape, splats);
    std::vector<std::pair<float, float>> drawn, expected;
    for (std::size_t i = 0; i < splats.used; ++i) {
        if (radiance[i].x > 1e-20f) drawn.emplace_back(positions[i].x, radiance[i].x);
    }
    for (std::uint64_t i = 0; i < kMutations; ++i) {
        RandomStream sample(4, i, 3, RandomDomain::MetropolisChain);
        sample.next_2d();  // whether the step is large, whether it is accepted
        Contribution contribution;
        landscape.evaluate(sample, contribution);
        if (contribution.brightness > 0)
            expected.emplace_back(contribution.position.x, contribution.radiance[0].x);
    }
    std::sort(drawn.begin(), drawn.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(drawn, expected);
}

}  // namespace
}  // namespace lxs::test
