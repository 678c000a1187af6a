// Protects the table of shares: each place knows its own moments, what is unusable is left out, a
// state goes on as it was, and memory is bounded.
#include "aips/core/tables/share_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::share_table_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};

/// Light of radiance 1: on the left photons have a variance of 4 and paths one of 1, on the right
/// photons one of 1/4 and paths one of 9.
ShareSample sample_at(RandomStream& random) {
    ShareSample s;
    const bool left = random.next() < 0.5f;
    s.position = {0.5f * random.next() + (left ? 0 : 0.5f), random.next(), 0};
    s.normal = kUp;
    s.weight = 1;
    s.photon_paths = 100;
    const double spread = left ? 2 : 0.5;  // two values, at 1 +- 1 times it, below none
    s.photons = random.next() < 1 / (1 + spread * spread) ? 1 + spread * spread : 0;
    s.squares = s.photon_paths * spread * spread;
    s.others = 3;
    s.continued = random.next() < 0.25f;
    if (s.continued) {
        const double chance = left ? 0.5 : 0.1;
        s.eye = random.next() < chance ? 1 / chance : 0;
        s.rays = 5;
    }
    return s;
}

void learn(ShareTable& table, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        RandomStream random(1, std::uint64_t(round), 0, RandomDomain::Eye);
        for (int i = 0; i < 4000; ++i)
            EXPECT_TRUE(table.add(sample_at(random)));
        table.update(4000);
    }
}

TEST(ShareTable, PlacesKnowTheirOwnVariances) {
    ShareTableSettings settings;
    settings.prior_count = 1e-3;
    ShareTable table(kScene, settings);
    EXPECT_EQ(table.at({0.2f, 0.5f, 0}, kUp), EyeShare{});
    learn(table, 40);
    EXPECT_GT(table.leaf_count(), 16u);
    const auto moments = table.moments();
    std::vector<EyeShare> numbers(moments.size());
    for (std::size_t leaf = 0; leaf < numbers.size(); ++leaf)
        numbers[leaf].share = float(leaf) / float(numbers.size());
    table.set_shares(numbers);
    double eye[2] = {}, photons[2] = {}, told[2] = {};
    for (const int right : {0, 1}) {
        for (float y = 0.05f; y < 1; y += 0.1f) {
            const float share = table.at({right ? 0.8f : 0.2f, y, 0}, kUp).share;
            const auto leaf = std::size_t(std::lround(share * float(numbers.size())));
            const ShareMoments& m = moments[leaf];
            eye[right] += (m.yy - m.xy) / m.continued / 10;
            photons[right] += m.spread / m.continued / 100 / 10;
            told[right] += m.squares / m.points / 100 / 10;
            EXPECT_NEAR(m.others / m.points, 3, 1e-9);
            EXPECT_NEAR(m.rays / m.continued, 5, 1e-9);
        }
    }
    EXPECT_NEAR(eye[0], 1, 0.3);
    EXPECT_NEAR(eye[1], 9, 2);
    EXPECT_NEAR(photons[0], 4, 0.8);
    EXPECT_NEAR(photons[1], 0.25, 0.2);
    EXPECT_NEAR(told[0], 4, 0.4);
    EXPECT_NEAR(told[1], 0.25, 0.2);
}

TEST(ShareTable, SplitsKeepWhatSeldomPathsTold) {
    ShareTable table(kScene);
    for (int round = 0; round < 40; ++round) {
        RandomStream random(3, std::uint64_t(round), 0, RandomDomain::Eye);
        for (int i = 0; i < 4000; ++i) {
            ShareSample s = sample_at(random);
            s.continued = i % 128 == 0;
            EXPECT_TRUE(table.add(s));
        }
        table.update(4000);
    }
    EXPECT_GT(table.leaf_count(), 64u);
    // 1250 went on, ten for each of so many leaves: each still knows what its parents were told.
    for (const ShareMoments& m : table.moments())
        EXPECT_TRUE(m.population == 0 || m.continued > 64) << m.population << ' ' << m.continued;
}

TEST(ShareTable, PopulationIsWhatIsSeen) {
    ShareTable table(kScene);
    learn(table, 10);
    double population = 0;
    for (const ShareMoments& m : table.moments())
        population += m.population;
    EXPECT_NEAR(population, 40000, 1);
    table.forget(0.5);
    population = 0;
    for (const ShareMoments& m : table.moments())
        population += m.population;
    EXPECT_NEAR(population, 20000, 1);
}

TEST(ShareTable, UnusableSamplesAreLeftOut) {
    ShareTable table(kScene);
    RandomStream random(2, 0, 0, RandomDomain::Eye);
    const ShareSample good = sample_at(random);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    constexpr double kTooMuch = std::numeric_limits<double>::infinity();
    for (double ShareSample::*value :
         {&ShareSample::weight, &ShareSample::photons, &ShareSample::squares, &ShareSample::others,
          &ShareSample::eye, &ShareSample::rays, &ShareSample::photon_paths}) {
        for (const double bad : {kNone, kTooMuch, -1.0}) {
            ShareSample sample = good;
            sample.*value = bad;
            EXPECT_FALSE(table.add(sample)) << bad;
        }
    }
    for (double ShareSample::*value :
         {&ShareSample::photons, &ShareSample::squares, &ShareSample::others, &ShareSample::eye}) {
        ShareSample sample = good;
        sample.weight = sample.*value = 1e200;
        EXPECT_FALSE(table.add(sample)) << "a product that is no number";
    }
    EXPECT_EQ(table.moments()[0].points, 0);
    EXPECT_THROW(table.set_shares(std::vector<EyeShare>(3)), std::invalid_argument);
    ShareTableSettings settings;
    settings.prior_count = 0;
    EXPECT_THROW(ShareTable(kScene, settings), std::invalid_argument);
}

TEST(ShareTable, MemoryIsBounded) {
    ShareTable table(kScene);
    learn(table, 60);
    EXPECT_LE(table.memory_bytes(), ShareTable::memory_bound_bytes({}));
}

/// All jobs, the last one first.
void backwards(std::uint32_t count, const Job& job) {
    for (std::uint32_t i = count; i-- > 0;)
        job(i);
}

/// A table that learned, by groups of samples or one by one, and has split.
ShareTable learned(const std::vector<std::vector<ShareSample>>& groups,
                   const ParallelFor& parallel) {
    ShareTable table(kScene);
    for (int round = 0; round < 4; ++round) {
        if (parallel) {
            table.add(groups, parallel);
        } else {
            for (const auto& group : groups) {
                for (const ShareSample& sample : group)
                    table.add(sample);
            }
        }
        table.update(4000);
    }
    return table;
}

TEST(ShareTable, LearnsTheSameFromManyAtOnceWhateverTheOrderOfJobs) {
    RandomStream random(3, 0, 0, RandomDomain::Guide);
    std::vector<std::vector<ShareSample>> groups(8);
    for (auto& group : groups) {
        for (int i = 0; i < 500; ++i)
            group.push_back(sample_at(random));
        group.back().eye = std::numeric_limits<double>::quiet_NaN();
    }
    const auto forwards = learned(groups, serial_for).moments();
    const auto reversed = learned(groups, backwards).moments();
    const auto one_by_one = learned(groups, nullptr).moments();
    ASSERT_GT(forwards.size(), 8u);
    ASSERT_EQ(forwards.size(), reversed.size());
    ASSERT_EQ(forwards.size(), one_by_one.size());
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        EXPECT_EQ(forwards[i].xx, reversed[i].xx);
        EXPECT_EQ(forwards[i].spread, reversed[i].spread);
        // Sums over groups are rounded in another order.
        EXPECT_NEAR(forwards[i].xx, one_by_one[i].xx, 1e-12 * one_by_one[i].xx);
        EXPECT_EQ(forwards[i].population, one_by_one[i].population);
    }
}

}  // namespace
}  // namespace aips::share_table_test
