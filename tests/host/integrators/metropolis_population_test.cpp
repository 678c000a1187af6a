// Protects the image of many short-lived chains: its expectation is right after a few passes, even
// where light is so rare that few renders find any of it. Over independent renders, against closed
// forms.
#include "path/metropolis_population.h"
#include "test_form.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numeric>

namespace lxs::test::metropolis_population_test {
namespace {

constexpr std::uint32_t kFilm = 32;  ///< pixels along each side
constexpr std::size_t kRarePixel = 9 * kFilm + 20;
constexpr float kRareWidth = 1.0f / 16;  ///< of an interval that a bright point must be in
constexpr double kRareBrightness = 10000;

/// Brightness 1 on the left half of the film, 0.01 on the right; in one pixel 10000 with a
/// probability of one in sixteen: a third of all light, which one plain sample in 16384 finds.
class RareLight final : public MetropolisTarget {
  public:
    void evaluate(PrimarySample& sample, Contribution& contribution) override {
        contribution.position = sample.next_2d() * static_cast<float>(kFilm);
        const float u = sample.next();
        double value = contribution.position.x < 0.5f * kFilm ? 1 : 0.01;
        if (pixel_of(contribution.position) == kRarePixel && u < kRareWidth)
            value = kRareBrightness;
        contribution.radiance.assign(1, Rgb(static_cast<float>(value)));
        contribution.brightness = value;
    }
    static std::size_t pixel_of(const Vec2& position) {
        return static_cast<std::size_t>(position.y) * kFilm + static_cast<std::size_t>(position.x);
    }
};

/// Nothing but black.
class Darkness final : public MetropolisTarget {
  public:
    void evaluate(PrimarySample& sample, Contribution& contribution) override {
        contribution.position = sample.next_2d() * static_cast<float>(kFilm);
        contribution.radiance.assign(1, Rgb(0.0f));
        contribution.brightness = 0;
    }
};

std::vector<double> next_samples(MetropolisPopulation& population, MetropolisTarget& target) {
    std::vector<double> brightness(population.starting_samples());
    Contribution contribution;
    for (std::size_t i = 0; i < brightness.size(); ++i) {
        RandomStream sample = population.plain_sample(population.plain_samples() + i);
        target.evaluate(sample, contribution);
        brightness[i] = contribution.brightness;
    }
    return brightness;
}

/// Light that a short render gives: in the pixel with the rare light, in the left half and in the
/// rest of the right half, each the mean over all pixels of the film.
using Parts = std::array<double, 3>;

Parts render(const MetropolisSettings& settings, std::uint64_t seed, int passes) {
    MetropolisPopulation population(settings, kFilm, kFilm, 1, seed);
    RareLight target;
    population.guess_from(next_samples(population, target));
    population.start_from(next_samples(population, target));
    Parts parts{};
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t chain = 0; chain < population.chains(); ++chain)
            population.run(chain, target);
        const auto splats = population.finish_pass();
        for (std::size_t i = 0; i < splats.positions.size(); ++i) {
            const Vec2 at = splats.positions[i];
            const std::size_t part =
                RareLight::pixel_of(at) == kRarePixel ? 0 : (at.x < 0.5f * kFilm ? 1 : 2);
            parts[part] += splats.radiance[i].x / double(splats.mutations) / passes;
        }
    }
    return parts;
}

constexpr double kPixels = double{kFilm} * kFilm;
const Parts kExpected{(kRareWidth * kRareBrightness + (1 - kRareWidth) * 0.01) / kPixels, 0.5,
                      0.01 * (kPixels / 2 - 1) / kPixels};

// 3 parts and their sum for each share of large steps: 12 z-tests at 1e-4 each.
TEST(MetropolisPopulation, ShortRendersHaveTheRightExpectationOfRareLight) {
    const auto renders = statistics::sized<std::uint64_t>(300, 600);
    for (const double large : {0.4, 0.1, 0.9}) {
        std::array<double, 4> sum{}, squares{};
        for (std::uint64_t seed = 1; seed <= renders; ++seed) {
            const Parts parts = render({.large_probability = large}, seed, 24);
            for (std::size_t k = 0; k < 4; ++k) {
                const double value =
                    k < 3 ? parts[k] : std::accumulate(parts.begin(), parts.end(), 0.0);
                sum[k] += value / double(renders);
                squares[k] += value * value / double(renders);
            }
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const double expected =
                k < 3 ? kExpected[k] : std::accumulate(kExpected.begin(), kExpected.end(), 0.0);
            const double error = std::sqrt((squares[k] - sum[k] * sum[k]) / double(renders - 1));
            std::cout << "large steps " << large << ", part " << k << ": " << sum[k] / expected
                      << " +- " << error / expected << "\n";
            EXPECT_LT(std::abs(sum[k] - expected), 3.9 * error) << "part " << k;
            EXPECT_LT(error, statistics::sized(0.15, 0.1) * expected)
                << "the test would miss what it is for";
        }
    }
}

// All samples that started the chains were dark, those that guessed b were not: chains without a
// weight of their own until large steps find light.
TEST(MetropolisPopulation, DarkStartLeavesLargeStepsAlone) {
    MetropolisPopulation population({.large_probability = 0.5}, kFilm, kFilm, 1, 7);
    Darkness dark;
    EXPECT_FALSE(population.guess_from(next_samples(population, dark)));
    RareLight light;
    EXPECT_TRUE(population.guess_from(next_samples(population, light)));
    population.start_from(next_samples(population, dark));
    const auto pass = [&](MetropolisTarget& target) {
        for (std::size_t chain = 0; chain < population.chains(); ++chain)
            population.run(chain, target);
        return population.finish_pass();
    };
    EXPECT_TRUE(pass(dark).positions.empty());
    // Without a chain's share only large steps give splats: about half of the mutations.
    const auto lit = pass(light);
    EXPECT_GT(lit.positions.size(), 400u);
    EXPECT_LT(lit.positions.size(), 624u);
    EXPECT_EQ(lit.mutations, kFilm * kFilm);
}

TEST(MetropolisPopulation, RenewsFromEnoughLargeStepsAndCountsThemAll) {
    MetropolisPopulation population({.large_probability = 0.5}, kFilm, kFilm, 1, 7);
    RareLight light;
    population.guess_from(next_samples(population, light));
    population.start_from(next_samples(population, light));
    for (int pass = 0; pass < 40; ++pass) {
        for (std::size_t chain = 0; chain < population.chains(); ++chain)
            population.run(chain, light);
        population.finish_pass();
    }
    EXPECT_EQ(population.counts().mutations, 40u * kFilm * kFilm);
    EXPECT_EQ(population.plain_samples(),
              2 * population.starting_samples() + population.counts().large);
    // 512 large steps a pass, 1024 to renew from: every second pass, or third where they are fewer.
    // A quarter of the chains each time, after all of them.
    EXPECT_GE(population.starts(), 32u + 13 * 8);
    EXPECT_LE(population.starts(), 32u + 20 * 8);
}

// Weights 0, 1, 2, 3, 0, 2 and 8 draws: each sample is drawn as often as its share says, to less
// than one, and any one draw alone has that distribution (chi-square over 8 x 4 cells in 20000
// offsets, significance 1e-4 each: 21.1 with 3 degrees of freedom).
TEST(Resampling, EachDrawAloneIsInProportion) {
    const std::array<double, 6> brightness{0, 1, 2, 3, 0, 2};
    constexpr std::size_t kDraws = 8;
    constexpr int kTrials = 20000;
    std::array<std::array<double, 6>, kDraws> counts{};
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
        const auto drawn = resample(brightness, kDraws, RandomStream(11, 0, trial).next());
        std::array<double, 6> together{};
        for (std::size_t k = 0; k < kDraws; ++k) {
            ++counts[k][drawn[k]];
            ++together[drawn[k]];
        }
        for (std::size_t i = 0; i < brightness.size(); ++i)
            ASSERT_LT(std::abs(together[i] - brightness[i]), 1);
    }
    for (const auto& draw : counts) {
        double statistic = 0;
        for (std::size_t i = 0; i < brightness.size(); ++i) {
            const double expected = kTrials * brightness[i] / 8;
            if (expected > 0) statistic += std::pow(draw[i] - expected, 2) / expected;
        }
        EXPECT_EQ(draw[0] + draw[4], 0);
        EXPECT_LT(statistic, 21.1);
    }
}

}  // namespace
}  // namespace lxs::test::metropolis_population_test
