// Protects the tables of directions: draws follow their density, what is learned is true, tables
// are there only where they pay, and memory is bounded.
#include "aips/core/tables/bounce_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"
#include "chi_square.h"

namespace aips::bounce_tables_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};

/// What a direction from a place is worth, on top of Lambert's cosine / pi.
using Importance = std::function<double(Vec3 position, Vec3 direction)>;

/// Rich within a cone about a tilted axis, a hundredth elsewhere.
double spot(Vec3 /*position*/, Vec3 w) {
    return dot(w, normalize(Vec3{0.6f, 0.3f, 0.7f})) > 0.93f ? 1 : 0.01;
}
double everywhere_alike(Vec3 /*position*/, Vec3 /*direction*/) {
    return 1;
}

struct Learning {
    int blocks = 20;
    int vertices = 2000;  ///< a block; as many paths
    std::uint64_t seed = 1;
    Vec3 normal = kUp;
};

Vec3 place(RandomStream& random) {
    const float x = random.next();
    return {x, random.next(), random.next()};
}

/// Directions are drawn from the mixture that the tables ask for, as a photon's are.
BounceScore draw(const BounceTables& tables, const Learning& how, const Importance& importance,
                 RandomStream& random) {
    BounceScore s;
    s.position = place(random);
    s.normal = how.normal;
    const BounceTable in_use = tables.at(s.position, s.normal);
    const Frame frame = Frame::world_aligned(s.normal);
    const bool guided = random.next() < in_use.share;
    const Vec2 u = random.next2();
    s.direction = cosine_square_direction(frame, guided ? in_use.table->sample(u).point : u);
    const double lambert = double(std::max(1e-6f, dot(s.direction, s.normal)) * kInvPi);
    const double density =
        in_use.table ? double(in_use.table->pdf(cosine_square_point(frame, s.direction))) : 1;
    s.plain = lambert;
    s.drawn = lambert * (1 - double(in_use.share) + double(in_use.share) * density);
    s.power = 3;
    const double part = importance(s.position, s.direction) * lambert / s.drawn;
    s.score = 9 * part * part * -std::log1p(-double(random.next()));
    s.cost = 3;
    return s;
}

void learn(BounceTables& tables, const Importance& importance, const Learning& how = {}) {
    for (int b = 0; b < how.blocks; ++b) {
        RandomStream random(how.seed, std::uint64_t(b), 0, RandomDomain::Guide);
        for (int i = 0; i < how.vertices; ++i)
            ASSERT_TRUE(tables.add(draw(tables, how, importance, random)));
        tables.update(how.vertices);
    }
}

TEST(CosineSquare, FramesAreContinuousAndRightHanded) {
    RandomStream random(1, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = square_to_uniform_sphere(random.next2());
        const Vec3 near = normalize(n + square_to_uniform_sphere(random.next2()) * 1e-3f);
        const Frame a = Frame::world_aligned(n), b = Frame::world_aligned(near);
        ASSERT_NEAR(dot(a.s, a.n), 0, 1e-6);
        ASSERT_NEAR(length(a.s), 1, 1e-6);
        ASSERT_NEAR(dot(cross(a.s, a.t), a.n), 1, 1e-6);
        if (dominant_axis(n) != dominant_axis(near)) continue;
        ASSERT_LT(length(a.s - b.s), 4e-3);
        ASSERT_LT(length(a.t - b.t), 4e-3);
    }
}

// On bins of the sphere that do not line up with the table's cells, the density per steradian is
// integrated by many points in each.
TEST(BounceTables, DirectionsFollowTheirDensity) {
    constexpr int kDraws = 100000, kBins = 10, kSub = 30;
    for (const Vec3 normal : {kUp, normalize(Vec3{0.5f, -0.6f, 0.4f})}) {
        BounceTables tables(kScene);
        learn(tables, spot, {.seed = 2, .normal = normal});
        const BounceTable in_use = tables.at({0.5f, 0.5f, 0.5f}, normal);
        ASSERT_TRUE(in_use.table);
        const Frame frame = Frame::world_aligned(normal);
        std::vector<double> observed(std::size_t{kBins} * kBins), expected(observed.size());
        RandomStream random(3, 0, 0, RandomDomain::Guide);
        for (int i = 0; i < kDraws; ++i) {
            const Vec3 w =
                cosine_square_direction(frame, in_use.table->sample(random.next2()).point);
            ++observed[cell_index(uniform_sphere_to_square(w), kBins)];
        }
        double sum = 0;
        for (int i = 0; i < kBins * kSub * kBins * kSub; ++i) {
            const int x = i % (kBins * kSub), y = i / (kBins * kSub);
            const Vec2 u{(float(x) + 0.5f) / (kBins * kSub), (float(y) + 0.5f) / (kBins * kSub)};
            const Vec3 w = square_to_uniform_sphere(u);
            const float cosine = dot(w, normal);
            if (cosine <= 0) continue;
            const double density =
                double(in_use.table->pdf(cosine_square_point(frame, w)) * cosine * kInvPi);
            const double mass = density * 4 * double(kPi) / (kBins * kSub * kBins * kSub);
            expected[cell_index(u, kBins)] += mass * kDraws;
            sum += mass;
        }
        EXPECT_NEAR(sum, 1, 2e-3);
        for (double& e : expected)
            e /= sum;
        const auto result = test::chi_square(observed, expected);
        EXPECT_GT(result.p_value, test::sidak(1e-4, 2)) << result.describe;
    }
}

// The density follows the mean of |f| over a cell; what was drawn by
// the tables themselves counts no more than what was drawn plainly.
TEST(BounceTables, LearnsAKnownDensity) {
    BounceTableSettings settings;
    settings.places.max_leaves = 6;
    settings.shares.gain = 1;  // a ramp gains a third at most
    BounceTables tables(kScene, settings);
    constexpr int kSide = BounceTables::kResolution;
    const Frame frame = Frame::world_aligned(kUp);
    // Constant in each cell: a ramp.
    const Importance ramp = [&](Vec3, Vec3 w) {
        return 0.2 + double(cell_index(cosine_square_point(frame, w), kSide) % kSide);
    };
    learn(tables, ramp, {.blocks = 40, .vertices = 5000, .seed = 4});
    const BounceTable in_use = tables.at({0.5f, 0.5f, 0.5f}, kUp);
    ASSERT_TRUE(in_use.table);
    for (int x = 0; x < kSide; ++x) {
        double column = 0;
        for (int y = 0; y < kSide; ++y) {
            column +=
                double(in_use.table->pdf({(float(x) + 0.5f) / kSide, (float(y) + 0.5f) / kSide})) /
                kSide;
        }
        // 200 000 photons, some 25 000 a column, whose roots vary by half their mean: 0.4 % of
        // standard error, and the prior's 16 photons.
        const double truth = (0.2 + x) / (0.2 + 3.5);
        EXPECT_NEAR(column, truth, 0.02 * truth + 1e-3) << x;
    }
}

TEST(BounceTables, KeepsPlacesAndFacesApart) {
    BounceTables tables(kScene);
    const Importance to_the_middle = [](Vec3 p, Vec3 w) {
        return (p.x < 0.5f) == (w.x > 0) ? 1 : 0.01;
    };
    learn(tables, to_the_middle, {.blocks = 30, .vertices = 3000, .seed = 5});
    EXPECT_GT(tables.leaf_count(), 6u);
    const Frame frame = Frame::world_aligned(kUp);
    const Vec2 right = cosine_square_point(frame, normalize(Vec3{1, 0, 1}));
    const Vec2 left = cosine_square_point(frame, normalize(Vec3{-1, 0, 1}));
    for (const float x : {0.2f, 0.8f}) {
        const BounceTable in_use = tables.at({x, 0.5f, 0.5f}, kUp);
        ASSERT_TRUE(in_use.table) << x;
        const double inwards = double(in_use.table->pdf(x < 0.5f ? right : left));
        EXPECT_GT(inwards, 3 * double(in_use.table->pdf(x < 0.5f ? left : right))) << x;
    }
    EXPECT_FALSE(tables.at({0.2f, 0.5f, 0.5f}, -kUp).table);
    EXPECT_FALSE(tables.at({0.2f, 0.5f, 0.5f}, {1, 0, 0}).table);
}

// A leaf that splits passes its table on: both halves are guided as it was, at once.
TEST(BounceTables, HalvesInheritTheTable) {
    BounceTableSettings settings;
    settings.places.split_count = 6000;  // effective: the leaf splits late
    BounceTables tables(kScene, settings);
    const Learning how{.blocks = 1, .vertices = 2000, .seed = 6};
    const Vec3 low{0.1f, 0.1f, 0.1f}, high{0.9f, 0.9f, 0.9f};
    std::uint32_t leaves = tables.leaf_count();
    for (std::uint64_t b = 0; b < 20 && leaves == 6; ++b) {
        ASSERT_EQ(tables.at(low, kUp).table, tables.at(high, kUp).table);
        Learning block = how;
        block.seed = 100 + b;
        learn(tables, spot, block);
        leaves = tables.leaf_count();
    }
    ASSERT_EQ(leaves, 7u);
    const BounceTable a = tables.at(low, kUp), b = tables.at(high, kUp);
    ASSERT_TRUE(a.table && b.table && a.table != b.table);
    EXPECT_GT(a.share, 0);
    EXPECT_EQ(a.share, b.share);
    for (int i = 0; i < 64; ++i) {
        const int x = i % 8, y = i / 8;
        const Vec2 p{(float(x) + 0.5f) / 8, (float(y) + 0.5f) / 8};
        EXPECT_NEAR(a.table->pdf(p), b.table->pdf(p), 1e-5f);
    }
}

// Where directions are alike there is nothing to gain: no table is in use, or stored.
TEST(BounceTables, NoTablesWhereTheyDoNotPay) {
    BounceTables tables(kScene);
    const std::size_t bytes = tables.memory_bytes();
    learn(tables, everywhere_alike, {.blocks = 40, .vertices = 2000, .seed = 7});
    EXPECT_EQ(tables.tables_in_use(), 0u);
    EXPECT_FALSE(tables.at({0.5f, 0.5f, 0.5f}, kUp).table);
    EXPECT_EQ(tables.memory_bytes(), bytes);
    EXPECT_EQ(tables.gain(), 1);
}

// What second moments fall by is what gain() says: the true ones are integrated over the cells.
TEST(BounceTables, GainIsTheFallOfTheSecondMoment) {
    BounceTables tables(kScene);
    learn(tables, spot, {.blocks = 40, .vertices = 5000, .seed = 8});
    RandomStream random(9, 0, 0, RandomDomain::Guide);
    double without = 0, with = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vec3 p = place(random);
        const Frame frame = Frame::world_aligned(kUp);
        const Vec2 u = random.next2();
        const double f = spot(p, cosine_square_direction(frame, u));
        const BounceTable in_use = tables.at(p, kUp);
        ASSERT_TRUE(in_use.table);
        const double share = double(in_use.share);
        without += f * f;
        with += f * f / (1 - share + share * double(in_use.table->pdf(u)));
    }
    EXPECT_GT(without / with, 1.8);
    EXPECT_NEAR(tables.gain(), without / with, 0.08 * without / with);
}

TEST(BounceTables, FollowsWhatChanges) {
    BounceTableSettings settings;
    settings.places.memory_paths = 20000;
    settings.moment_paths = 10000;
    BounceTables tables(kScene, settings);
    const Importance turned = [](Vec3 p, Vec3 w) { return spot(p, {-w.x, -w.y, w.z}); };
    learn(tables, spot, {.blocks = 20, .vertices = 2000, .seed = 10});
    learn(tables, turned, {.blocks = 40, .vertices = 2000, .seed = 11});
    const Frame frame = Frame::world_aligned(kUp);
    const BounceTable in_use = tables.at({0.5f, 0.5f, 0.5f}, kUp);
    ASSERT_TRUE(in_use.table);
    const Vec3 axis = normalize(Vec3{0.6f, 0.3f, 0.7f});
    EXPECT_GT(in_use.table->pdf(cosine_square_point(frame, {-axis.x, -axis.y, axis.z})),
              2 * in_use.table->pdf(cosine_square_point(frame, axis)));
}

// Light that passes through the surface is no part of the square: it is judged, but not learned.
TEST(BounceTables, LightThatPassesThroughSpeaksAgainstATable) {
    BounceTables tables(kScene);
    RandomStream random(12, 0, 0, RandomDomain::Guide);
    for (int b = 0; b < 20; ++b) {
        for (int i = 0; i < 2000; ++i) {
            BounceScore s = draw(tables, {}, spot, random);
            ASSERT_TRUE(tables.add(s));
            s.direction = s.direction * -1.0f;
            s.drawn = s.plain;
            s.score = 9;
            ASSERT_TRUE(tables.add(s));
        }
        tables.update(2000);
    }
    EXPECT_EQ(tables.tables_in_use(), 0u);
}

TEST(BounceTables, RefusesWhatIsNotAScore) {
    BounceTables tables(kScene);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const BounceScore good{{0.5f, 0.5f, 0}, kUp, kUp, 1, 1, 1, 0.3, 0.3};
    EXPECT_TRUE(tables.add(good));
    for (const double bad : {nan, -1.0, std::numeric_limits<double>::infinity()}) {
        for (double BounceScore::*member :
             {&BounceScore::power, &BounceScore::score, &BounceScore::cost, &BounceScore::drawn}) {
            BounceScore s = good;
            s.*member = bad;
            EXPECT_FALSE(tables.add(s)) << bad;
        }
    }
    BounceScore s = good;
    s.direction.x = float(nan);
    EXPECT_FALSE(tables.add(s));
    EXPECT_THROW(BounceTables(kScene, {.prior_count = 0}), std::invalid_argument);
    EXPECT_THROW(BounceTables(kScene, {.moment_paths = nan}), std::invalid_argument);
}

TEST(BounceTables, SameCallsSameBits) {
    BounceTables first(kScene), second(kScene);
    for (BounceTables* tables : {&first, &second})
        learn(*tables, spot, {.seed = 13});
    ASSERT_GT(first.tables_in_use(), 0u);
    ASSERT_EQ(first.tables_in_use(), second.tables_in_use());
    RandomStream random(14, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 p = place(random);
        const BounceTable a = first.at(p, kUp), b = second.at(p, kUp);
        ASSERT_EQ(a.share, b.share);
        ASSERT_EQ(a.table == nullptr, b.table == nullptr);
        const Vec2 u = random.next2();
        if (!a.table) continue;
        ASSERT_EQ(a.table->pdf(u), b.table->pdf(u));
    }
}

TEST(BounceTables, MemoryIsBounded) {
    BounceTableSettings settings;
    settings.places.max_leaves = 64;
    settings.places.split_mass = 1e-6;
    BounceTables tables(kScene, settings);
    const std::size_t before = tables.memory_bytes();
    learn(tables, spot, {.blocks = 60, .vertices = 5000, .seed = 15});
    EXPECT_EQ(tables.leaf_count(), 64u);
    EXPECT_GT(tables.tables_in_use(), 32u);
    EXPECT_LE(tables.memory_bytes(),
              before + 64 * DirectionalTable::memory_bytes(BounceTables::kResolution));
    EXPECT_LE(tables.memory_bytes(), BounceTables::memory_bound_bytes(settings));
    EXPECT_LT(BounceTables::memory_bound_bytes({}), 4u << 20);
}

}  // namespace
}  // namespace aips::bounce_tables_test
