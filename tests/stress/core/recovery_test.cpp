// Protects: a direction or a place that was worth nothing for long is found again once it matters,
// in a number of updates that is stated.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "aips/core/sampling/random.h"
#include "aips/core/tables/bounce_tables.h"
#include "aips/core/tables/paper_tables.h"
#include "aips/core/trees/primary_tree.h"
#include "aips/core/trees/score_cache.h"
#include "stress_case.h"

namespace recovery_test {
namespace {

using namespace aips;
using namespace stress;

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};
/// Scored paths between two updates: one in sixteen of an iteration of 16384.
constexpr int kPaths = 1024;
/// As guide=adaptive has it.
constexpr double kMemory = 5e5;

/// Gives nodes errors by number.
class ErrorByNode final : public ErrorCriterion {
  public:
    double errors[2] = {0, 0};
    double error(const NodeView& view) const override {
        return errors[view.node.bounds.lower.x > 0 ? 1 : 0];
    }
};

TEST(StressRecovery, OfThePapersTables) {
    NodeTree tree(kUnit, {.max_nodes = 2, .node_photons = 2});
    for (const float x : {0.1f, 0.2f, 0.9f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    Photon right;  // the upper node as the lower one sees it; and the lower one itself
    right.depth = 2;
    right.previous = {0.1f, 0.5f, 0.5f};
    right.position = {0.9f, 0.5f, 0.5f};
    right.direction = {-1, 0, 0};
    Photon left = right;
    left.position = {0.05f, 0.5f, 0.5f};
    left.direction = {1, 0, 0};
    PaperTables tables({});
    ErrorByNode criterion;
    const auto update = [&](double ours, double theirs) {
        criterion.errors[0] = ours;
        criterion.errors[1] = theirs;
        tree.update_errors(criterion, false);
        tables.update(tree, std::vector{right, left});
    };
    const std::size_t cell = cell_index(uniform_sphere_to_square({1, 0, 0}), 8);
    for (int pass = 0; pass < 1000; ++pass) {
        update(1, 0);
        tables.end_pass();
    }
    const float extinct = tables.relative_error(0)[cell];
    EXPECT_GT(extinct, 0.05f) << "the floor keeps a tenth of the mean error";
    int updates = 0;
    for (; tables.relative_error(0)[cell] < 10 && updates < 100; ++updates)
        update(1, 100);
    EXPECT_LE(updates, 1);
    record("an error of 0 seen in one direction over 1000 passes, then one of 100",
           "p(w) " + std::to_string(extinct) + " while extinct, above 10 after " +
               std::to_string(updates) + " update of at most 1");
}

/// Blocks of paths from the tree's own density, worth something in the half of u[0] given.
void shoot(PrimaryTree& tree, bool upper, std::uint64_t block) {
    RandomStream random(1, block, 0, RandomDomain::Guide);
    for (int i = 0; i < kPaths; ++i) {
        const PrimaryPoint u{random.next(), random.next(), random.next(), random.next()};
        const PrimarySample s = tree.sample(u);
        const bool matters = (s.point[0] >= 0.5f) == upper && s.point[1] < 0.125f;
        const double value = matters ? 1 / double(s.pdf) : 0;
        tree.add(s.point, value * value);
    }
    tree.update(kPaths);
    tree.set_mixture({0.15, 0});
}

TEST(StressRecovery, OfThePrimaryTree) {
    PrimaryTree tree({.max_leaves = 1024, .memory_paths = kMemory});
    const int before = sized(600, 5000);
    for (int block = 0; block < before; ++block)
        shoot(tree, false, std::uint64_t(block));
    const PrimaryPoint place{0.75f, 0.05f, 0.5f, 0.5f};
    const float extinct = tree.pdf(place);
    EXPECT_LT(extinct, 0.2f);
    int updates = 0;
    for (; tree.pdf(place) < 1 && updates < 5000; ++updates)
        shoot(tree, true, std::uint64_t(before) + std::uint64_t(updates));
    EXPECT_LE(updates, 100);
    record("all scores in one corner for " + std::to_string(before) +
               " updates of 1024 paths, then in another",
           "density there " + std::to_string(extinct) + ", as without a guide after " +
               std::to_string(updates) + " updates of at most 100");
}

/// The roulette's cache limits a score to what its leaf knew: it must climb nevertheless.
TEST(StressRecovery, OfTheScoreCache) {
    ScoreCache cache(kUnit, {.memory_paths = kMemory});
    const auto update = [&](double score) {
        for (int i = 0; i < 64; ++i)
            cache.add({{0.5f, 0.5f, 0}, kUp, i == 0 ? score : 0, 4});
        cache.update(kPaths);
    };
    update(1e-30);
    const int before = sized(2000, 200000);
    for (int i = 0; i < before; ++i)
        update(0);
    const float extinct = cache.at({0.5f, 0.5f, 0}, kUp).score;
    int updates = 0;
    for (; cache.at({0.5f, 0.5f, 0}, kUp).score < 0.1f / 64 && updates < 5000; ++updates)
        update(1);
    // At worst each score doubles the sum, from the least float to 1: 150 times.
    EXPECT_LE(updates, 400);
    record("scores of 1e-30 once, then none for " + std::to_string(before) +
               " updates, then 1 for one vertex of 64",
           "expected " + std::to_string(extinct) + ", a tenth of the mean after " +
               std::to_string(updates) + " updates of at most 400");
}

/// Directions from Lambert's lobe and the table, worth something about one axis.
void scatter(BounceTables& tables, Vec3 rich, std::uint64_t block) {
    RandomStream random(2, block, 0, RandomDomain::Guide);
    const Frame frame = Frame::world_aligned(kUp);
    for (int i = 0; i < kPaths; ++i) {
        BounceScore s;
        s.position = {0.5f, 0.5f, 0.5f};
        s.normal = kUp;
        const BounceTable in_use = tables.at(s.position, s.normal);
        const bool guided = random.next() < in_use.share && in_use.table;
        const Vec2 u = random.next2();
        s.direction = cosine_square_direction(frame, guided ? in_use.table->sample(u).point : u);
        s.plain = double(std::max(1e-6f, s.direction.z) * kInvPi);
        const double table =
            in_use.table ? double(in_use.table->pdf(cosine_square_point(frame, s.direction))) : 1;
        const double share = in_use.share;
        s.drawn = s.plain * (1 - share + share * table);
        s.power = 1;
        const double value = dot(s.direction, rich) > 0.9f ? s.plain / s.drawn : 0;
        s.score = value * value;
        s.cost = 2;
        tables.add(s);
    }
    tables.update(kPaths);
}

double density_of(const BounceTables& tables, Vec3 direction) {
    const BounceTable in_use = tables.at({0.5f, 0.5f, 0.5f}, kUp);
    if (!in_use.table) return 1;
    const Vec2 place = cosine_square_point(Frame::world_aligned(kUp), direction);
    return 1 - double(in_use.share) + double(in_use.share) * double(in_use.table->pdf(place));
}

TEST(StressRecovery, OfTheBounceTables) {
    BounceTableSettings settings;
    settings.places.memory_paths = kMemory;
    BounceTables tables(kUnit, settings);
    const Vec3 first = normalize(Vec3{0.6f, 0, 0.8f}), then = normalize(Vec3{-0.6f, 0, 0.8f});
    const int before = sized(600, 5000);
    for (int block = 0; block < before; ++block)
        scatter(tables, first, std::uint64_t(block));
    const double extinct = density_of(tables, then);
    EXPECT_GE(extinct, 0.249) << "the Bsdf's share";
    EXPECT_LT(extinct, 0.5);
    int updates = 0;
    for (; density_of(tables, then) < 1 && updates < 5000; ++updates)
        scatter(tables, then, std::uint64_t(before) + std::uint64_t(updates));
    EXPECT_LE(updates, 200);
    record("all scores about one direction for " + std::to_string(before) +
               " updates of 1024 vertices, then about another",
           "density there " + std::to_string(extinct) + ", as without a table after " +
               std::to_string(updates) + " updates of at most 200");
}

}  // namespace
}  // namespace recovery_test
