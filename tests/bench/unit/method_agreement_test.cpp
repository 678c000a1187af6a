// Protects what `aips-bench agreement` says: equal expectations pass however often one looks, an
// error of 3 % is found, bias is forgiven as far as it is claimed, and too much noise is no
// agreement.
#include <cmath>

#include "method_agreement.h"

#include <gtest/gtest.h>

#include "reference_checks.h"
#include "synthetic_image.h"

namespace bench::test::method_agreement_test {
namespace {

constexpr int kSize = 32, kSeeds = 8;
constexpr double kNoise = 0.04;  ///< of a pixel: 1 % of a block's luminance

const std::vector<double> kAlike(64, 1.0);

std::vector<double> blocks(double mean, double deviation, std::mt19937& random) {
    return block_luminances(noisy_image(kSize, kSize, mean, deviation, random));
}

SeedBlocks runs(double mean, double deviation, std::mt19937& random) {
    SeedBlocks seeds;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
        seeds[seed] = blocks(mean, deviation, random);
    return seeds;
}

/// Chunks of unequal weight, as references have.
BlockSample references(double mean, std::mt19937& random) {
    BlockSample sample;
    for (const double weight : {1.0, 1.0, 2.0, 4.0, 1.0, 1.0, 2.0, 4.0}) {
        sample.means.push_back(blocks(mean, kNoise / std::sqrt(weight), random));
        sample.weights.push_back(weight);
    }
    return sample;
}

TEST(MethodAgreement, EqualExpectationsAreReportedAsRarelyAsTheFamilyWiseLevelSays) {
    std::mt19937 random(1);
    int reported = 0, at_five_percent = 0;
    const auto count = [&](const std::optional<Agreement>& found) {
        const statistics::Comparison& test = found->comparison;
        reported += test.differs();
        at_five_percent += test.smallest_p < 1 - std::pow(0.95, 1.0 / double(test.tests));
    };
    // 300 families: 0.03 reports are expected, and 15 +- 3.8 if the level were 5 %.
    for (int study = 0; study < 150; ++study) {
        const SeedBlocks method = runs(1, kNoise, random);
        count(agreement_with_references(references(1, random), method, nullptr, kAlike));
        count(agreement_with_baseline(runs(1, kNoise, random), method, kAlike));
    }
    EXPECT_EQ(reported, 0);
    EXPECT_LE(at_five_percent, 30);
    EXPECT_GE(at_five_percent, 3);
}

TEST(MethodAgreement, PlantedErrorOfThreePercentIsFound) {
    std::mt19937 random(2);
    for (const double factor : {1.03, 0.97}) {
        const SeedBlocks method = runs(factor, kNoise, random);
        const auto against_references =
            agreement_with_references(references(1, random), method, nullptr, kAlike);
        EXPECT_TRUE(against_references->comparison.differs());
        EXPECT_FALSE(against_references->agrees());
        EXPECT_NEAR(against_references->mean_ratio, factor, 0.003);
        EXPECT_FALSE(against_references->bias);
        EXPECT_FALSE(agreement_with_baseline(runs(1, kNoise, random), method, kAlike)->agrees());
    }
}

TEST(MethodAgreement, ErrorOfOneBlockIsFoundThere) {
    std::mt19937 random(3);
    SeedBlocks method = runs(1, kNoise, random);
    for (auto& [seed, means] : method)
        means[19] *= 1.3;
    const auto found = agreement_with_baseline(runs(1, kNoise, random), method, kAlike);
    EXPECT_TRUE(found->comparison.differs());
    EXPECT_EQ(found->comparison.smallest_at, 19u);
}

TEST(MethodAgreement, BiasIsForgivenAsFarAsItIsClaimed) {
    std::mt19937 random(4);
    const auto factors = bias_factors(2, 1, {});
    // Bias -4 % at radius 2, -1 % at 1, on top of it 3 % in the second case.
    const RadiusBias claim{runs(0.96, kNoise, random), runs(0.99, kNoise, random), factors};
    const auto sample = references(1, random);
    const auto as_claimed =
        agreement_with_references(sample, runs(0.96, kNoise, random), &claim, kAlike);
    EXPECT_TRUE(as_claimed->agrees());
    EXPECT_NEAR(*as_claimed->bias, -0.04, 0.005);
    EXPECT_NEAR(as_claimed->comparison.mean_ratio, 1, 0.005);
    const auto beyond =
        agreement_with_references(sample, runs(0.91, kNoise, random), &claim, kAlike);
    EXPECT_TRUE(beyond->comparison.differs());
    // A method without radius claims none.
    EXPECT_TRUE(agreement_with_references(sample, runs(0.96, kNoise, random), nullptr, kAlike)
                    ->comparison.differs());
}

TEST(MethodAgreement, WhatNoiseHidesIsNoAgreement) {
    std::mt19937 random(5);
    const auto found = agreement_with_references(references(1, random),
                                                 runs(1, 40 * kNoise, random), nullptr, kAlike);
    EXPECT_FALSE(found->comparison.differs());
    EXPECT_FALSE(found->agrees());
}

TEST(MethodAgreement, TheRatiosIntervalHoldsTheTruthAsOftenAsItSays) {
    std::mt19937 random(9);
    // 200 intervals of 95 %: 190 +- 3.1 hold the truth; of one standard error 136 +- 6.6 would.
    int holding = 0;
    for (int study = 0; study < 200; ++study) {
        const auto found = agreement_with_references(references(1, random),
                                                     runs(1.1, kNoise, random), nullptr, kAlike);
        const RatioInterval interval = found->ratio_interval();
        holding += interval.low < 1.1 && 1.1 < interval.high;
    }
    EXPECT_GE(holding, 178);
    EXPECT_LE(holding, 199);
    // All seeds alike: nothing is left to doubt.
    const SeedBlocks same{{1, kAlike}, {2, kAlike}, {3, kAlike}};
    const RatioInterval point = agreement_with_baseline(same, same, kAlike)->ratio_interval();
    EXPECT_EQ(point.low, 1);
    EXPECT_EQ(point.high, 1);
}

TEST(MethodAgreement, ANoisyBlockHidesNoCommonFactor) {
    std::mt19937 random(8);
    // A lamp in one block, a hundred times as bright as the others and as noisy as it is bright.
    std::exponential_distribution<double> lamp(0.01);
    SeedBlocks baseline = runs(1, kNoise, random), method = runs(1.01, kNoise, random);
    for (auto* sample : {&baseline, &method}) {
        for (auto& [seed, means] : *sample)
            means[5] = lamp(random);
    }
    const auto weights = block_weights({all_means(baseline), all_means(method)});
    const auto alike = agreement_with_baseline(baseline, method, kAlike);
    EXPECT_FALSE(alike->comparison.differs());
    const auto weighted = agreement_with_baseline(baseline, method, weights);
    EXPECT_TRUE(weighted->comparison.differs());
    EXPECT_EQ(weighted->comparison.smallest_at, 64u);
    EXPECT_NEAR(weighted->comparison.mean_ratio, 1.01, 0.003);
    EXPECT_EQ(weighted->mean_ratio, alike->mean_ratio);
}

TEST(MethodAgreement, HeavyChunksCountByTheirWeight) {
    std::mt19937 random(6);
    // Among light chunks that are off by noise, one of weight 1000 holds the mean.
    BlockSample sample = references(1, random);
    for (double& value : sample.means[3])
        value = 2;
    sample.weights[3] = 1000;
    const auto found = agreement_with_references(sample, runs(1, kNoise, random), nullptr, kAlike);
    EXPECT_NEAR(found->mean_ratio, 0.5, 0.01);
    EXPECT_NEAR(found->comparison.mean_ratio, 0.5, 0.01);
}

TEST(MethodAgreement, FewerThanThreeSeedsSayNothing) {
    std::mt19937 random(7);
    SeedBlocks two = runs(1, kNoise, random);
    while (two.size() > 2)
        two.erase(two.begin());
    EXPECT_FALSE(agreement_with_references(references(1, random), two, nullptr, kAlike));
    EXPECT_FALSE(agreement_with_baseline(runs(1, kNoise, random), two, kAlike));
    // Nor do more whose claim was measured with two.
    const RadiusBias claim{runs(1, kNoise, random), two, bias_factors(2, 1, {})};
    EXPECT_FALSE(
        agreement_with_references(references(1, random), runs(1, kNoise, random), &claim, kAlike));
}

}  // namespace
}  // namespace bench::test::method_agreement_test
