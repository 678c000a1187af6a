// Protects the score cache: true means, faces of walls apart, caution where little is known.
#include "aips/core/trees/score_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::score_cache_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1}, kDown{0, 0, -1};
/// Standard errors of a two-sided test with significance 1e-5.
constexpr double kSigmas = 4.5;

/// Mean score of vertices at a point of the floor.
using Field = std::function<double(Vec3)>;

Vec3 floor_point(RandomStream& random) {
    const Vec2 u = random.next2();
    return {u.x, u.y, 0};
}

/// Scores are field * X, X exponential with mean 1 (variance = mean^2); costs uniform in [1, 3).
VertexScore draw_vertex(RandomStream& random, const Field& field) {
    VertexScore vertex{floor_point(random), kUp};
    vertex.score = -std::log1p(-double(random.next())) * field(vertex.position);
    vertex.cost = 1 + 2 * double(random.next());
    return vertex;
}

struct Learning {
    int blocks = 12;
    int vertices = 5000;  ///< a block; as many paths
    std::uint64_t seed = 1;
};

void learn(ScoreCache& cache, const Field& field, const Learning& learning) {
    for (int b = 0; b < learning.blocks; ++b) {
        RandomStream random(learning.seed, std::uint64_t(b), 0, RandomDomain::Guide);
        for (int i = 0; i < learning.vertices; ++i)
            EXPECT_TRUE(cache.add(draw_vertex(random, field)));
        cache.update(learning.vertices);
    }
}

double halves(Vec3 p) {
    return p.x < 0.5f ? 4 : 0.25;
}

/// Rich within a fifth of the floor that is symmetric about its middle: halves look alike.
double middle_spot(Vec3 p) {
    return std::abs(p.x - 0.5f) < 0.1f ? 10 : 0.01;
}

TEST(ScoreCache, KnowsNothingBeforeTheFirstUpdate) {
    ScoreCache cache(kScene);
    EXPECT_FALSE(cache.at({0.5f, 0.5f, 0}, kUp).known);
    cache.update(1000);
    EXPECT_FALSE(cache.at({0.5f, 0.5f, 0}, kUp).known);
    cache.add({{0.5f, 0.5f, 0}, kUp, 3, 2});
    EXPECT_FALSE(cache.at({0.5f, 0.5f, 0}, kUp).known);  // frozen
    cache.update(1);
    const auto learned = cache.at({0.5f, 0.5f, 0}, kUp);
    EXPECT_TRUE(learned.known);
    EXPECT_FLOAT_EQ(learned.score, 3);
    EXPECT_FLOAT_EQ(learned.cost, 2);
}

// Over each half, the mean of the expectations is the mean of what was drawn there; the standard
// error is that of the vertices remembered.
TEST(ScoreCache, ExpectationsAreTheMeansOfThePieces) {
    ScoreCache cache(kScene);
    constexpr Learning kLearning{.blocks = 20, .vertices = 10000, .seed = 2};
    learn(cache, halves, kLearning);
    ASSERT_GT(cache.leaf_count(), 8u);
    for (const float x : {0.0f, 0.5f}) {
        const double truth = halves({x, 0, 0});
        double score = 0, cost = 0;
        constexpr int kSide = 200;
        for (int i = 0; i < kSide * kSide; ++i) {
            const int column = i % kSide, row = i / kSide;
            const Vec3 p{x + 0.5f * (float(column) + 0.5f) / kSide, (float(row) + 0.5f) / kSide, 0};
            const auto expected = cache.at(p, kUp);
            score += double(expected.score) / (kSide * kSide);
            cost += double(expected.cost) / (kSide * kSide);
        }
        // Splits drop what was met before a probe began: an eighth is a cautious share of it all.
        const double n = 0.5 * kLearning.blocks * kLearning.vertices / 8;
        EXPECT_NEAR(score, truth, kSigmas * truth / std::sqrt(n)) << "x from " << x;
        EXPECT_NEAR(cost, 2, kSigmas / std::sqrt(3 * n)) << "x from " << x;
    }
}

TEST(ScoreCache, RefinesWhereTheFieldChangesOffThePlanes) {
    ScoreCache cache(kScene);
    const Field field = [](Vec3 p) { return p.x < 0.3f && p.y < 0.7f ? 1 : 1e-3; };
    learn(cache, field, {.blocks = 30, .vertices = 10000, .seed = 3});
    for (const Vec3 p : {Vec3{0.25f, 0.3f, 0}, Vec3{0.1f, 0.65f, 0}})
        EXPECT_NEAR(cache.at(p, kUp).score, 1, 0.4);
    for (const Vec3 p : {Vec3{0.35f, 0.3f, 0}, Vec3{0.1f, 0.75f, 0}, Vec3{0.9f, 0.9f, 0}})
        EXPECT_LT(cache.at(p, kUp).score, 0.05);
}

// Without splits by mass: halves that differ are split, and know at once what was met in them.
TEST(ScoreCache, SplitsBetweenHalvesThatDiffer) {
    ScoreCacheSettings settings;
    settings.split_mass = 1;
    settings.split_gain = 0;
    ScoreCache cache(kScene, settings);
    learn(cache, halves, {.blocks = 2, .vertices = 4000, .seed = 20});  // the first fits the box
    EXPECT_EQ(cache.leaf_count(), 7u);
    EXPECT_NEAR(cache.at({0.49f, 0.5f, 0}, kUp).score, 4, kSigmas * 4 / std::sqrt(2000));
    EXPECT_NEAR(cache.at({0.51f, 0.5f, 0}, kUp).score, 0.25, 0.05);
}

TEST(ScoreCache, DoesNotSplitHalvesThatDifferByChance) {
    ScoreCacheSettings settings;
    settings.split_mass = 1;
    settings.split_gain = 0;
    ScoreCache cache(kScene, settings);
    learn(cache, [](Vec3) { return 1; }, {.blocks = 20, .vertices = 1000, .seed = 21});
    EXPECT_EQ(cache.leaf_count(), 6u);
}

// One vertex in fifty has a score: a leaf that met none by chance must not be thought worthless.
TEST(ScoreCache, RareScoresMakeNoLeafWorthlessByChance) {
    ScoreCache cache(kScene);
    for (std::uint64_t b = 0; b < 20; ++b) {
        RandomStream random(22, b, 0, RandomDomain::Guide);
        for (int i = 0; i < 10000; ++i) {
            const Vec3 p = floor_point(random);
            cache.add({p, kUp, random.next() < 0.02f ? 50.0 : 0.0, 1});
        }
        cache.update(10000);
        constexpr int kSide = 50;
        for (int i = 0; i < kSide * kSide; ++i) {
            const int x = i % kSide, y = i / kSide;
            const Vec3 p{float(x) / kSide, float(y) / kSide, 0};
            ASSERT_GT(cache.at(p, kUp).score, 0.2f) << "block " << b;
            ASSERT_LT(cache.at(p, kUp).score, 5.0f) << "block " << b;
        }
    }
    EXPECT_GT(cache.leaf_count(), 20u);
}

TEST(ScoreCache, SeesAFieldWhoseHalvesAreAlike) {
    ScoreCache cache(kScene);
    learn(cache, middle_spot, {.blocks = 16, .vertices = 10000, .seed = 4});
    EXPECT_NEAR(cache.at({0.5f, 0.5f, 0}, kUp).score, 10, 4);
    EXPECT_LT(cache.at({0.2f, 0.5f, 0}, kUp).score, 0.5);
    EXPECT_LT(cache.at({0.8f, 0.5f, 0}, kUp).score, 0.5);
}

// A room that fills a millionth of a wide scene's ground is resolved as well.
TEST(ScoreCache, FindsARoomInAWideScene) {
    ScoreCache cache(Bounds{{-999, -999, -1}, {1, 1, 1}});
    learn(cache, halves, {.blocks = 10, .vertices = 5000, .seed = 5});
    EXPECT_NEAR(cache.at({0.25f, 0.5f, 0}, kUp).score, 4, 2);
    EXPECT_LT(cache.at({0.75f, 0.5f, 0}, kUp).score, 0.6);
}

// A box fitted to the floor is widened when a table's vertices follow.
TEST(ScoreCache, ResolvesWhatIsMetLater) {
    ScoreCache cache(kScene);
    learn(cache, [](Vec3) { return 1; }, {.blocks = 1, .vertices = 1000, .seed = 6});
    for (std::uint64_t b = 0; b < 16; ++b) {
        RandomStream random(7, b, 0, RandomDomain::Guide);
        for (int i = 0; i < 5000; ++i) {
            VertexScore vertex = draw_vertex(random, [](Vec3) { return 1; });
            cache.add(vertex);
            vertex.position.z = 0.8f;
            vertex.score *= 100;
            cache.add(vertex);
        }
        cache.update(5000);
    }
    EXPECT_NEAR(cache.at({0.4f, 0.4f, 0}, kUp).score, 1, 0.7);
    EXPECT_NEAR(cache.at({0.4f, 0.4f, 0.8f}, kUp).score, 100, 40);
}

TEST(ScoreCache, KeepsTheFacesOfAThinWallApart) {
    for (int axis = 0; axis < 3; ++axis) {
        ScoreCache cache(kScene);
        RandomStream random(8, std::uint64_t(axis), 0, RandomDomain::Guide);
        Vec3 front{0.3f, -0.2f, 0.4f};
        front[axis] = 0.9f;
        const Vec3 middle{0.5f, 0.5f, 0.5f};
        for (int i = 0; i < 4000; ++i) {
            Vec3 p{random.next(), random.next(), random.next()};
            p[axis] = 0.5f;
            cache.add({p, front, 1, 1});
            cache.add({p, -front, 0, 3});
        }
        cache.update(8000);
        EXPECT_NEAR(cache.at(middle, front).score, 1, 0.01) << "axis " << axis;
        EXPECT_LT(cache.at(middle, -front).score, 0.01) << "axis " << axis;
        EXPECT_NEAR(cache.at(middle, -front).cost, 3, 0.01) << "axis " << axis;
    }
}

// Vertices without a score count: the expectation sinks towards 0, but no faster than the prior
// allows.
TEST(ScoreCache, NoLeafIsWorthlessByAFewVertices) {
    const ScoreCacheSettings settings;
    for (const int zeros : {1, 4, 16, 20000}) {
        ScoreCache cache(kScene, settings);
        for (int i = 0; i < 40000; ++i)
            cache.add({{0.5f, 0.5f, 1}, kDown, 1, 1});
        for (int i = 0; i < zeros; ++i)
            cache.add({{0.5f, 0.5f, 0}, kUp, 0, 1});
        cache.update(1000);
        const double mean = 40000.0 / (40000 + zeros);
        const double weight = settings.prior_count / mean;
        const double prior = weight / (weight + zeros);
        EXPECT_NEAR(cache.at({0.5f, 0.5f, 0}, kUp).score, mean * prior, 1e-6) << zeros;
        // Where nothing was met, the whole cache's mean is all there is.
        EXPECT_NEAR(cache.at({0.5f, 0.5f, 0}, {1, 0, 0}).score, mean, 1e-6) << zeros;
    }
}

// The outer side of a room's wall, where most photons end, faces as the wall across the room does,
// where few arrive, worth very different scores: uneven scores must not keep the two together.
TEST(ScoreCache, TellsARoomFromItsOuterWall) {
    ScoreCache cache(kScene);
    for (std::uint64_t b = 0; b < 20; ++b) {
        RandomStream random(9, b, 0, RandomDomain::Guide);
        for (int i = 0; i < 5000; ++i) {
            const Vec2 u = random.next2();
            cache.add({{0, u.x, u.y}, {-1, 0, 0}, 0, 1});
            if (i % 100) continue;
            const double score = std::pow(10.0, 8 * double(random.next()));
            cache.add({{1, u.x, u.y}, {-1, 0, 0}, score, 4});
        }
        cache.update(5000);
    }
    const double inside = double(cache.at({1, 0.5f, 0.5f}, {-1, 0, 0}).score);
    const double outside = double(cache.at({0, 0.5f, 0.5f}, {-1, 0, 0}).score);
    EXPECT_GT(inside, 1e3 * outside);
    EXPECT_NEAR(cache.at({0, 0.5f, 0.5f}, {-1, 0, 0}).cost, 1, 0.1);
}

// A rare score must not be held back: of 400 vertices one has all.
TEST(ScoreCache, RareScoresKeepTheirMean) {
    ScoreCacheSettings settings;
    settings.split_gain = 1;
    settings.split_mass = 1;  // one leaf
    ScoreCache cache(kScene, settings);
    constexpr int kBlocks = 100, kVertices = 4000;
    for (int b = 0; b < kBlocks; ++b) {
        RandomStream random(10, std::uint64_t(b), 0, RandomDomain::Guide);
        for (int i = 0; i < kVertices; ++i) {
            const Vec3 p = floor_point(random);
            cache.add({p, kUp, random.next() < 1.0f / 400 ? 400.0 : 0.0, 1});
        }
        cache.update(kVertices);
    }
    const double error = std::sqrt(399.0 / (kBlocks * kVertices));
    EXPECT_NEAR(cache.at({0.5f, 0.5f, 0}, kUp).score, 1, kSigmas * error);
}

TEST(ScoreCache, FollowsAFieldThatChanges) {
    ScoreCacheSettings settings;
    settings.memory_paths = 40000;
    ScoreCache cache(kScene, settings);
    const Field mirrored = [](Vec3 p) { return halves({1 - p.x, p.y, p.z}); };
    const Vec3 left{0.25f, 0.5f, 0}, right{0.75f, 0.5f, 0};
    learn(cache, halves, {.blocks = 40, .vertices = 5000, .seed = 11});
    EXPECT_GT(cache.at(left, kUp).score, 8 * cache.at(right, kUp).score);
    // Within the memory: what is left of the old is about 1 / e.
    learn(cache, mirrored, {.blocks = 8, .vertices = 5000, .seed = 12});
    EXPECT_GT(cache.at(right, kUp).score, cache.at(left, kUp).score);
    learn(cache, mirrored, {.blocks = 32, .vertices = 5000, .seed = 13});
    EXPECT_GT(cache.at(right, kUp).score, 6 * cache.at(left, kUp).score);
}

TEST(ScoreCache, RefusesWhatIsNotAScore) {
    ScoreCache cache(kScene);
    const Vec3 p{0.5f, 0.5f, 0};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {double(nan), -1.0, inf, 1e300}) {
        EXPECT_FALSE(cache.add({p, kUp, bad, 1}));
        EXPECT_FALSE(cache.add({p, kUp, 1, bad}));
    }
    EXPECT_FALSE(cache.add({{nan, 0, 0}, kUp, 1, 1}));
    EXPECT_FALSE(cache.add({p, {0, nan, 0}, 1, 1}));
    cache.update(10);
    EXPECT_FALSE(cache.at(p, kUp).known);
}

TEST(ScoreCache, BadSettingsThrow) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const ScoreCacheSettings& settings) {
        EXPECT_THROW(ScoreCache(kScene, settings), std::invalid_argument);
    };
    refused({.max_leaves = 5});
    refused({.max_leaves = (1u << 24) + 1});
    refused({.split_count = 3});
    refused({.split_gain = nan});
    refused({.split_mass = 0});
    refused({.memory_paths = 0});
    refused({.prior_count = 0});
    refused({.prior_count = std::numeric_limits<double>::infinity()});
}

TEST(ScoreCache, SameCallsSameBits) {
    ScoreCache first(kScene), second(kScene);
    for (ScoreCache* cache : {&first, &second})
        learn(*cache, middle_spot, {.blocks = 8, .vertices = 5000, .seed = 14});
    ASSERT_EQ(first.leaf_count(), second.leaf_count());
    RandomStream random(15, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 p = floor_point(random);
        ASSERT_EQ(first.at(p, kUp).score, second.at(p, kUp).score);
        ASSERT_EQ(first.at(p, kUp).cost, second.at(p, kUp).cost);
    }
}

TEST(ScoreCache, MemoryIsFlatAndLeavesAreBounded) {
    ScoreCacheSettings settings;
    settings.max_leaves = 64;
    settings.split_mass = 1e-6;
    ScoreCache cache(kScene, settings);
    const std::size_t bytes = cache.memory_bytes();
    learn(cache, middle_spot, {.blocks = 30, .vertices = 5000, .seed = 16});
    EXPECT_EQ(cache.leaf_count(), 64u);
    EXPECT_EQ(cache.memory_bytes(), bytes);
    EXPECT_LE(bytes, ScoreCache::memory_bound_bytes(settings));
}

// All vertices at one point, in a scene without extent or with none: sides stop shrinking, and
// expectations stay finite.
TEST(ScoreCache, DegenerateScenesDoNotSplit) {
    for (const Bounds& scene : {kScene, Bounds{}, Bounds{{1, 1, 1}, {1, 1, 1}},
                                Bounds{{0, 0, 0}, {Bounds::kInf, 1, 1}}}) {
        ScoreCacheSettings settings;
        settings.split_mass = 1e-9;
        ScoreCache cache(scene, settings);
        for (int round = 0; round < 100; ++round) {
            for (int i = 0; i < 100; ++i)
                cache.add({{0.3f, 0.3f, 0.3f}, kUp, double(i % 3), 1});
            cache.update(1);
        }
        EXPECT_LE(cache.leaf_count(), 6u + 36u);
        EXPECT_NEAR(cache.at({0.3f, 0.3f, 0.3f}, kUp).score, 0.99, 0.01);
        const float nan = std::numeric_limits<float>::quiet_NaN();
        EXPECT_TRUE(cache.at({nan, nan, nan}, {nan, nan, nan}).known);
    }
}

}  // namespace
}  // namespace aips::score_cache_test
