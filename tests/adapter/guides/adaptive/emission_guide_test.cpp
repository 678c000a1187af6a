// Protects the guide of emission: it draws what its pdf says, never without the plain density, goes
// to what is worth something, and only while that pays.
#include "guides/adaptive/emission_guide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "aips/core/sampling/random.h"

namespace aips::emission_guide_test {
namespace {

/// Part in the image of a start.
using Part = std::function<double(LightIndex, const PrimaryPoint&)>;

PrimaryPoint random_point(RandomStream& random) {
    return {random.next(), random.next(), random.next(), random.next()};
}

EmissionStart draw(const EmissionGuide& guide, RandomStream& random) {
    const float u_light = random.next();
    return guide.sample(u_light, random_point(random));
}

bool in_box(const PrimaryPoint& u) {
    return u[0] >= 0.5f && u[0] < 0.75f && u[1] < 0.25f;
}

/// Light 1 is worth 1 in a box of 1/16 of its starts; all else is worth little.
double bright_box(LightIndex light, const PrimaryPoint& u) {
    return light == 1 && in_box(u) ? 1 : 0.02;
}

/// Blocks of paths shot by the guide itself, all of cost 1.
void learn(EmissionGuide& guide, const Part& part, int blocks, std::uint64_t seed,
           int paths = 5000) {
    for (int b = 0; b < blocks; ++b) {
        RandomStream random(seed, std::uint64_t(b), 0, RandomDomain::Guide);
        for (int i = 0; i < paths; ++i) {
            const EmissionStart start = draw(guide, random);
            const double value = part(start.light, start.point) / start.pdf;
            guide.add({start, value * value, 1});
        }
        guide.update(paths);
    }
}

DiscreteDistribution choice_of(const std::vector<float>& powers) {
    return DiscreteDistribution(powers);
}

/// Light 0 brings nothing and light 1 only from an eighth of its starts.
TEST(EmissionGuide, TellsWhichShareIsStarved) {
    const DiscreteDistribution plain = choice_of({1, 3});
    EmissionGuide guide(2, plain);
    EXPECT_EQ(guide.starved_share(0.25), 0);
    learn(
        guide,
        [](LightIndex light, const PrimaryPoint& u) {
            return light == 1 && u[0] < 0.5f && u[2] < 0.25f ? 1.0 : 0.0;
        },
        40, 5);
    ASSERT_TRUE(guide.on());
    EXPECT_NEAR(guide.starved_share(0.25), 1 - 0.75 / 8, 0.02);
    EXPECT_EQ(guide.starved_share(0.1), 0) << "below the defensive share";
    EXPECT_EQ(guide.starved_share(100), 1);
}

TEST(EmissionGuide, OffIsThePlainChoiceAndTheIdentity) {
    const DiscreteDistribution plain = choice_of({1, 5, 2});
    EmissionGuide guide(3, plain);
    guide.update(1000);  // nothing was learned from them
    EXPECT_FALSE(guide.on());
    EXPECT_EQ(guide.gain(), 1);
    RandomStream random(1, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 1000; ++i) {
        const float u_light = random.next();
        const PrimaryPoint u = random_point(random);
        const EmissionStart start = guide.sample(u_light, u);
        EXPECT_EQ(start.light, plain.sample(u_light).index);
        EXPECT_EQ(start.point, u);
        EXPECT_EQ(start.pdf, double(plain.pdf(start.light)));
    }
}

/// In each cell of lights x 2^4 halves the mean of 1 / pdf is the cell's volume. The squares of
/// standard scores sum to a chi-square of as many degrees.
void expect_draws_follow_pdf(const EmissionGuide& guide, std::uint64_t seed) {
    constexpr std::size_t kLights = 3;
    constexpr double kBeyond = 93.4;  // 48 degrees of freedom: with probability 1e-4
    constexpr int kDraws = 400000;
    constexpr double kVolume = 1.0 / 16;
    std::vector<double> sum(16 * kLights), squares(16 * kLights);
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < kDraws; ++i) {
        const EmissionStart start = draw(guide, random);
        ASSERT_TRUE(start.pdf > 0 && std::isfinite(start.pdf) && start.light < kLights);
        std::size_t cell = start.light;
        for (const double x : start.point) {
            ASSERT_TRUE(x >= 0 && x < 1);
            cell = 2 * cell + (x >= 0.5f ? 1 : 0);
        }
        sum[cell] += 1 / start.pdf;
        squares[cell] += 1 / (start.pdf * start.pdf);
    }
    double statistic = 0;
    for (std::size_t c = 0; c < sum.size(); ++c) {
        const double mean = sum[c] / kDraws;
        const double variance = (squares[c] / kDraws - mean * mean) / kDraws;
        ASSERT_LT(std::sqrt(variance), 0.1 * kVolume) << "too few draws to tell, cell " << c;
        statistic += (mean - kVolume) * (mean - kVolume) / variance;
    }
    EXPECT_LT(statistic, kBeyond);
}

TEST(EmissionGuide, DrawsFollowThePdf) {
    const DiscreteDistribution plain = choice_of({1, 5, 2});
    EmissionGuide guide(3, plain);
    expect_draws_follow_pdf(guide, 2);
    std::vector<EmissionSeed> seeds(200, {2, {0.3f, 0.3f, 0.6f, 0}, 1});
    for (std::size_t i = 0; i < seeds.size(); ++i)
        seeds[i].point[3] = 0.001 * double(i);
    guide.add_seeds(seeds);
    guide.update(0);
    ASSERT_TRUE(guide.on());
    expect_draws_follow_pdf(guide, 3);  // seeds alone
    learn(guide, bright_box, 10, 4);
    ASSERT_TRUE(guide.on());
    ASSERT_GT(guide.leaf_count(), 10u);
    expect_draws_follow_pdf(guide, 5);
}

/// Defensive sampling: no photon is more than 1 / plain_share times as heavy as a plain one.
TEST(EmissionGuide, PdfIncludesThePlainShareEverywhere) {
    const std::vector<float> powers{1, 5, 2, 0.01f};
    const DiscreteDistribution plain = choice_of(powers);
    const EmissionGuideSettings settings;
    EmissionGuide guide(4, plain, settings);
    const Part box_only = [](LightIndex light, const PrimaryPoint& u) {
        return light == 1 && in_box(u) ? 1.0 : 0.0;
    };
    learn(guide, box_only, 10, 6);
    ASSERT_TRUE(guide.on());
    RandomStream random(7, 0, 0, RandomDomain::Guide);
    double heaviest = 0;
    for (int i = 0; i < 200000; ++i) {
        const EmissionStart start = draw(guide, random);
        heaviest = std::max(heaviest, double(plain.pdf(start.light)) / start.pdf);
    }
    // Met where nothing was learned. Probabilities of lights are rounded to 2^-24.
    EXPECT_NEAR(heaviest * settings.plain_share, 1, 1e-3);
}

TEST(EmissionGuide, TheLightThatIsWorthSomethingIsChosen) {
    const DiscreteDistribution plain = choice_of({1, 1, 1, 1});
    EmissionGuide guide(4, plain);
    learn(
        guide, [](LightIndex light, const PrimaryPoint&) { return light == 2 ? 1.0 : 0.0; }, 5, 8);
    ASSERT_TRUE(guide.on());
    RandomStream random(9, 0, 0, RandomDomain::Guide);
    constexpr int kDraws = 20000;
    int chosen = 0;
    for (int i = 0; i < kDraws; ++i)
        chosen += draw(guide, random).light == 2 ? 1 : 0;
    // A quarter of the plain 15 %, and all of the rest: there are no seeds.
    const double expected = 0.15 / 4 + 0.85;
    EXPECT_NEAR(chosen / double(kDraws), expected, 4 * std::sqrt(0.25 / kDraws));
}

TEST(EmissionGuide, GoesToWhatIsWorthMoreAndTellsWhatItGains) {
    const DiscreteDistribution plain = choice_of({1, 1});
    EmissionGuide guide(2, plain);
    learn(guide, bright_box, 30, 10);
    ASSERT_TRUE(guide.on());
    const auto second_moment = [](const EmissionGuide& g) {
        RandomStream random(11, 0, 0, RandomDomain::Guide);
        double sum = 0;
        for (int i = 0; i < 50000; ++i) {
            const EmissionStart start = draw(g, random);
            sum += std::pow(bright_box(start.light, start.point) / start.pdf, 2) / 50000;
        }
        return sum;
    };
    double gained = second_moment(EmissionGuide(2, plain)) / second_moment(guide);
    EXPECT_GT(gained, 3);
    // Per cost, of densities while it learned.
    gained /= 1 + kLookUpCost;
    EXPECT_NEAR(guide.gain(), gained, 0.3 * gained);
}

TEST(EmissionGuide, SeedsActBeforeAnythingIsLearned) {
    const DiscreteDistribution plain = choice_of({1, 1, 0});
    EmissionGuide guide(3, plain);
    RandomStream random(12, 0, 0, RandomDomain::Guide);
    guide.add_seeds({{{2, {0.5f, 0.5f, 0.5f, 0.5f}, 1000}}});  // shines not at all
    guide.add_seeds({{{7, {0.5f, 0.5f, 0.5f, 0.5f}, 1000}}});  // does not exist
    for (int round = 0; round < 10; ++round) {
        std::vector<EmissionSeed> seeds;
        for (int i = 0; i < 200; ++i) {
            PrimaryPoint u = random_point(random);
            for (double& x : u)
                x = 0.5 + 0.25 * x;
            seeds.push_back({1, u, 1});
        }
        guide.add_seeds(seeds);
        guide.update(0);
    }
    ASSERT_TRUE(guide.on());
    constexpr int kDraws = 20000;
    int seeded = 0, lights[3] = {};
    for (int i = 0; i < kDraws; ++i) {
        const EmissionStart start = draw(guide, random);
        ++lights[start.light];
        bool near = start.light == 1;
        for (const double x : start.point)
            near = near && x >= 0.5f && x < 0.75f;
        seeded += near ? 1 : 0;
    }
    EXPECT_EQ(lights[2], 0);
    // The learned density's share is plain as yet: half of it goes to light 1, and all of the
    // seeds'.
    const double share = EmissionGuideSettings{}.seed_share;
    const double expected = (1 - share) / 2 + share;
    EXPECT_NEAR(lights[1] / double(kDraws), expected, 4 * std::sqrt(0.25 / kDraws));
    // In the seeds' box of 1/256 of the light's starts. Leaves that were split guess how older
    // seeds lay in them, so that part of these is beside it.
    EXPECT_GT(seeded / double(kDraws), share / 2);
    EXPECT_LT(seeded / double(kDraws), share + 0.02);
}

TEST(EmissionGuide, SwitchesOffWhereGuidingDoesNotPayAndOnWhereItDoes) {
    EmissionGuideSettings settings;
    settings.memory_paths = 20000;
    settings.trial_paths = 0;
    const DiscreteDistribution plain = choice_of({1, 1});
    EmissionGuide guide(2, plain, settings);
    const Part alike = [](LightIndex, const PrimaryPoint&) { return 1.0; };
    learn(guide, alike, 10, 13);
    EXPECT_FALSE(guide.on());
    EXPECT_LE(guide.gain(), 1);
    learn(guide, bright_box, 20, 14);
    EXPECT_TRUE(guide.on());
    EXPECT_GT(guide.gain(), 1.5);
    learn(guide, alike, 40, 15);
    EXPECT_FALSE(guide.on());
}

TEST(EmissionGuide, Deterministic) {
    const DiscreteDistribution plain = choice_of({1, 5, 2});
    EmissionGuide a(3, plain), b(3, plain);
    learn(a, bright_box, 5, 16);
    learn(b, bright_box, 5, 16);
    RandomStream random(17, 0, 0, RandomDomain::Guide), same(17, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 1000; ++i) {
        const EmissionStart x = draw(a, random), y = draw(b, same);
        EXPECT_TRUE(x.light == y.light && x.point == y.point && x.pdf == y.pdf);
    }
}

TEST(EmissionGuide, WhatIsNoScoreChangesNothing) {
    const DiscreteDistribution plain = choice_of({1, 1});
    EmissionGuide guide(2, plain);
    guide.add({{5, {}, 1}, 1, 1});  // no such light
    guide.add({{0, {}, 0}, 1, 1});  // cannot have been drawn
    guide.update(1000);
    EXPECT_FALSE(guide.on());
    EXPECT_EQ(guide.gain(), 1);
}

TEST(EmissionGuide, MemoryIsBoundedForOneLightAndForMany) {
    EmissionGuideSettings settings;
    settings.max_leaves = 1024;
    for (const std::size_t lights : {1u, 50u}) {
        const DiscreteDistribution plain = choice_of(std::vector<float>(lights, 1.0f));
        EmissionGuide guide(lights, plain, settings);
        const std::size_t before = guide.memory_bytes();
        learn(
            guide,
            [](LightIndex light, const PrimaryPoint& u) {
                return std::exp(6 * double(u[0] * u[1] + u[2])) * (1 + light);
            },
            30, 18);
        EXPECT_GT(guide.leaf_count(), std::max<std::size_t>(200, lights)) << lights;
        EXPECT_LE(guide.leaf_count(), settings.max_leaves) << lights;
        EXPECT_EQ(guide.memory_bytes(), before) << lights;
        EXPECT_LE(guide.memory_bytes(), EmissionGuide::memory_bound_bytes(plain, settings));
    }
    // Lights share the leaves.
    const auto bound = [](const std::vector<float>& powers) {
        return double(EmissionGuide::memory_bound_bytes(choice_of(powers)));
    };
    for (const std::size_t lights : {50u, 5000u})
        EXPECT_LT(bound(std::vector<float>(lights, 1.0f)), 1.5 * bound({1}));
    // Dead ones take none.
    std::vector<float> powers(100, 0.0f);
    powers[17] = 1;
    EXPECT_GT(bound(powers), bound({1}));
    EXPECT_LT(bound(powers), 1.1 * bound({1}));
}

}  // namespace
}  // namespace aips::emission_guide_test
