// Protects eq. 5 in the tables: neighbours by last hits, their errors of now, floors, inheritance,
// bounds.
#include "aips/core/tables/paper_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::paper_tables_test {
namespace {

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};

/// Errors set from outside.
class GivenErrors final : public ErrorCriterion {
  public:
    explicit GivenErrors(std::vector<double> errors) : errors_(std::move(errors)) {}
    double error(const NodeView& view) const override {
        return errors_[std::size_t(view.node.bounds.center().x * float(errors_.size()))];
    }

  private:
    std::vector<double> errors_;
};

/// Four slabs along x, of the given errors from left to right.
NodeTree slabs(const std::vector<double>& errors) {
    NodeTree tree(Bounds{{0, 0.49f, 0.49f}, {1, 0.51f, 0.51f}},
                  {.max_nodes = 4, .node_photons = 2});
    // The medians fall at 1/4, 1/2 and 3/4.
    for (const float x : {0.1f, 0.4f, 0.6f, 0.9f, 0.95f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    EXPECT_EQ(tree.node_count(), 4u);
    tree.update_errors(GivenErrors(errors), false);
    return tree;
}

Photon segment(Vec3 from, Vec3 to, std::uint16_t depth = 2) {
    Photon l;
    l.position = to;
    l.previous = from;
    l.direction = normalize(from - to);
    l.depth = depth;
    return l;
}

Vec3 slab_center(int i) {
    return {0.125f + 0.25f * float(i), 0.5f, 0.5f};
}

float value_towards(const PaperTables& tables, const NodeTree& tree, Vec3 from, Vec3 to) {
    const auto table = tables.relative_error(tree.locate(from));
    return table[cell_index(uniform_sphere_to_square(normalize(to - from)), tables.resolution())];
}

double mean_of(std::span<const float> table) {
    return std::accumulate(table.begin(), table.end(), 0.0) / double(table.size());
}

TEST(PaperTables, UniformBeforeAnythingIsKnown) {
    const PaperTables tables({.resolution = 4});
    for (const float v : tables.relative_error(17))
        EXPECT_EQ(v, 1);
    EXPECT_EQ(tables.relative_error(0).size(), 16u);
}

// A node that sees error 1 to its left and error 3 to its right: eq. 5 by hand.
TEST(PaperTables, RelativeErrorIsEquation5) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    PaperTables tables({.resolution = 4, .floor_share = 0.1f});
    const std::vector<Photon> photons{segment(slab_center(1), slab_center(0)),
                                      segment(slab_center(1), slab_center(2))};
    tables.update(tree, photons);
    const double floor = 0.1 * (1 + 3) / 2;
    const double mean = (1 + 3 + 14 * floor) / 16;
    EXPECT_NEAR(value_towards(tables, tree, slab_center(1), slab_center(0)), 1 / mean, 1e-5);
    EXPECT_NEAR(value_towards(tables, tree, slab_center(1), slab_center(2)), 3 / mean, 1e-5);
    EXPECT_NEAR(value_towards(tables, tree, slab_center(1), {0.375f, 0.5f, 9}), floor / mean, 1e-5);
    EXPECT_NEAR(mean_of(tables.relative_error(tree.locate(slab_center(1)))), 1, 1e-6);
}

// The earlier end of a segment learns of the later one; the other way round, or both, if asked for.
TEST(PaperTables, EitherEndLearns) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    const std::vector<Photon> photons{segment(slab_center(1), slab_center(3))};
    const auto learned = [&](bool earlier, bool later) {
        PaperTables tables({.resolution = 4, .earlier_learns = earlier, .later_learns = later});
        tables.update(tree, photons);
        return std::pair(value_towards(tables, tree, slab_center(1), slab_center(3)) > 1,
                         value_towards(tables, tree, slab_center(3), slab_center(1)) > 1);
    };
    EXPECT_EQ(learned(true, false), std::pair(true, false));
    EXPECT_EQ(learned(false, true), std::pair(false, true));
    EXPECT_EQ(learned(true, true), std::pair(true, true));
}

/// Glass and mirrors have no nodes: what leaves them teaches nobody.
TEST(PaperTables, SegmentsFromSpecularSurfacesAreIgnored) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    std::vector<Photon> photons{segment(slab_center(1), slab_center(3))};
    photons[0].from_specular = true;
    PaperTables tables({.resolution = 4, .later_learns = true});
    tables.update(tree, photons);
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (const float v : tables.relative_error(i))
            EXPECT_EQ(v, 1);
    }
}

TEST(PaperTables, SeveralNeighboursInACellAreAveraged) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    PaperTables tables({.resolution = 4, .floor_share = 0.5f});
    const std::vector<Photon> photons{segment(slab_center(0), slab_center(1)),
                                      segment(slab_center(0), slab_center(2))};
    tables.update(tree, photons);
    const double mean = (4 + 15 * 2.0) / 16;
    EXPECT_NEAR(value_towards(tables, tree, slab_center(0), slab_center(3)), 4 / mean, 1e-5);
}

TEST(PaperTables, SegmentsFromTheLightAndBadOnesAreIgnored) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    PaperTables tables({.resolution = 4});
    std::vector<Photon> photons{segment(slab_center(1), slab_center(0), 1),
                                segment(slab_center(1), slab_center(0))};
    photons[1].previous.x = std::numeric_limits<float>::quiet_NaN();
    photons.push_back(segment(slab_center(1), slab_center(0)));
    photons[2].direction.y = std::numeric_limits<float>::infinity();
    tables.update(tree, photons);
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (const float v : tables.relative_error(i))
            EXPECT_EQ(v, 1);
    }
}

TEST(PaperTables, ZeroErrorsAroundGiveAUniformTable) {
    const NodeTree tree = slabs({0, 0, 0, 0});
    PaperTables tables({.resolution = 4});
    tables.update(tree, std::vector<Photon>{segment(slab_center(1), slab_center(0))});
    for (const float v : tables.relative_error(1))
        EXPECT_EQ(v, 1);
}

TEST(PaperTables, EnormousErrorsStayFiniteAndPositive) {
    const NodeTree tree = slabs({1e280, 1e-300, 1e200, 0});
    PaperTables tables({.resolution = 4});
    std::vector<Photon> photons;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
            if (a != b) photons.push_back(segment(slab_center(a), slab_center(b)));
        }
    }
    tables.update(tree, photons);
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (const float v : tables.relative_error(i))
            ASSERT_TRUE(std::isfinite(v) && v > 0);
    }
}

// Errors change under a table that no new photon names: eq. 5 takes those of now.
TEST(PaperTables, TakesTheErrorsThatNeighboursHaveNow) {
    NodeTree tree = slabs({1, 5, 3, 7});
    PaperTables now({.resolution = 4}), landed({.resolution = 4, .present_errors = false});
    const std::vector<Photon> photons{segment(slab_center(1), slab_center(0)),
                                      segment(slab_center(1), slab_center(2))};
    const auto left_to_right = [&](const PaperTables& tables) {
        return value_towards(tables, tree, slab_center(1), slab_center(0)) /
               value_towards(tables, tree, slab_center(1), slab_center(2));
    };
    for (PaperTables* tables : {&now, &landed}) {
        tables->update(tree, photons);
        EXPECT_NEAR(left_to_right(*tables), 1 / 3.0, 1e-5);
    }
    tree.update_errors(GivenErrors({8, 5, 2, 7}), false);
    for (PaperTables* tables : {&now, &landed})
        tables->update(tree, {});
    EXPECT_NEAR(left_to_right(now), 4, 1e-5);
    EXPECT_NEAR(left_to_right(landed), 1 / 3.0, 1e-5);
    for (PaperTables* tables : {&now, &landed})
        tables->update(tree, photons);
    EXPECT_NEAR(left_to_right(now), 4, 1e-5);
    EXPECT_NEAR(left_to_right(landed), (1 + 8) / (3.0 + 2), 1e-5) << "the mean of both times";
}

// A neighbour that has split since is its halves.
TEST(PaperTables, FollowsNeighboursThatSplit) {
    NodeTree tree(Bounds{{0, 0.49f, 0.49f}, {1, 0.51f, 0.51f}},
                  {.max_nodes = 3, .node_photons = 2});
    for (const float x : {0.1f, 0.6f, 0.9f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    tree.update_errors(GivenErrors({2, 2}), false);
    PaperTables tables({.resolution = 4, .floor_share = 0.01f});
    const Vec3 here{0.2f, 0.5f, 0.5f};
    tables.update(tree, std::vector<Photon>{segment(here, {0.9f, 0.5f, 0.5f}),
                                            segment(here, {0.2f, 0.5f, 0.9f})});
    tree.insert({0.95f, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 3u);
    // By the middle of each node: the left one at 0.175, the new ones at 0.55 and 0.875.
    tree.update_errors(GivenErrors({2, 2, 2, 2, 2, 4, 2, 2, 12, 2}), false);
    tables.update(tree, {});
    const float aside = value_towards(tables, tree, here, {0.2f, 0.5f, 0.9f});
    EXPECT_NEAR(value_towards(tables, tree, here, {0.9f, 0.5f, 0.5f}) / aside, (4 + 12) / 2.0 / 2.0,
                1e-4);
}

TEST(PaperTables, RemembersTheLastFourNeighboursOfACell) {
    const NodeTree tree = slabs({1, 5, 3, 7});
    PaperTables tables({.resolution = 4, .floor_share = 0.01f});
    std::vector<Photon> photons(6, segment(slab_center(0), slab_center(1)));
    photons.push_back(segment(slab_center(0), {0.125f, 0.5f, 0.9f}));  // error 1, another cell
    tables.update(tree, photons);
    photons.assign(3, segment(slab_center(0), slab_center(3)));
    tables.update(tree, photons);
    tables.end_pass();
    tables.update(tree, {});
    const float up = value_towards(tables, tree, slab_center(0), {0.125f, 0.5f, 0.9f});
    EXPECT_NEAR(value_towards(tables, tree, slab_center(0), slab_center(3)) / up, (3 * 7 + 5) / 4.0,
                1e-4);
}

TEST(PaperTables, OldNeighboursCountOnceAfterThePassWhereErrorsAreThoseOfPhotons) {
    PaperTables tables({.resolution = 4, .floor_share = 0.01f, .present_errors = false});
    const NodeTree first = slabs({1, 1, 1, 1});
    std::vector<Photon> photons(100, segment(slab_center(0), slab_center(1)));
    tables.update(first, photons);
    tables.end_pass();
    const NodeTree later = slabs({1, 1, 1, 3});
    photons = {segment(slab_center(0), slab_center(3))};
    photons.push_back(segment(slab_center(0), {0.125f, 0.5f, 0.9f}));  // error 1, another cell
    tables.update(later, photons);
    const float to_right = value_towards(tables, later, slab_center(0), slab_center(3));
    const float up = value_towards(tables, later, slab_center(0), {0.125f, 0.5f, 0.9f});
    EXPECT_NEAR(to_right / up, (1 + 3) / 2.0, 1e-4);
}

TEST(PaperTables, NewNodesCopyTheTableOfTheNodeTheySplitFrom) {
    NodeTree tree(kUnit, {.max_nodes = 8, .node_photons = 2});
    tree.insert({0.1f, 0.5f, 0.5f}, 1);
    tree.insert({0.2f, 0.5f, 0.5f}, 1);
    tree.update_errors(GivenErrors({2}), false);
    PaperTables tables({.resolution = 4});
    tables.update(tree, std::vector<Photon>{segment({0.1f, 0.5f, 0.5f}, {0.2f, 0.5f, 0.5f})});
    const auto root = tables.relative_error(0);
    const std::vector<float> before(root.begin(), root.end());
    tree.insert({0.9f, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    tables.update(tree, {});
    const auto child = tables.relative_error(1);
    EXPECT_EQ(std::vector<float>(child.begin(), child.end()), before);
}

TEST(PaperTables, MemoryStaysWithinItsBound) {
    const NodeTreeSettings settings{.max_nodes = 200, .node_photons = 8};
    NodeTree tree(kUnit, settings);
    PaperTables tables({.resolution = 8});
    PaperTables landed({.resolution = 8, .present_errors = false});
    RandomStream random(1, 0, 0, RandomDomain::Photon);
    for (int iteration = 0; iteration < 30; ++iteration) {
        std::vector<Photon> photons;
        for (int i = 0; i < 300; ++i) {
            const Vec3 a{random.next(), random.next(), random.next()};
            photons.push_back(segment(a, {random.next(), random.next(), random.next()}));
            tree.insert(photons.back().position, random.next());
        }
        tree.update_errors(PaperErrorCriterion(), true);
        for (PaperTables* either : {&tables, &landed}) {
            either->update(tree, photons);
            ASSERT_LE(either->memory_bytes(), PaperTables::memory_bound_bytes(200, 8));
        }
    }
    EXPECT_EQ(tree.node_count(), 200u);
}

TEST(PaperTables, RefusesBadSettings) {
    EXPECT_THROW(PaperTables({.resolution = 0}), std::invalid_argument);
    EXPECT_THROW(PaperTables({.resolution = 65}), std::invalid_argument);
    EXPECT_THROW(PaperTables({.floor_share = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace aips::paper_tables_test
