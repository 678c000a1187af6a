// Protects the guide's kd-tree: lookup against brute force, weights, errors over passes, memory.
#include "aips/core/trees/kd_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::kd_tree_test {
namespace {

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};

Vec3 random_point(RandomStream& random) {
    const Vec2 u = random.next2();
    return {u.x * u.x, u.y, random.next()};
}

NodeTree filled_tree(const NodeTreeSettings& settings, int photons, std::uint64_t seed) {
    NodeTree tree(kUnit, settings);
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < photons; ++i)
        tree.insert(random_point(random), random.next());
    return tree;
}

/// A criterion with a known answer.
class CountCriterion final : public ErrorCriterion {
  public:
    double error(const NodeView& view) const override {
        return double(view.node.values.count) * view.volume;
    }
};

class NanCriterion final : public ErrorCriterion {
  public:
    double error(const NodeView&) const override { return std::nan(""); }
};

/// Node whose box holds p in the half-open sense of the splits.
std::uint32_t brute_force_locate(const NodeTree& tree, Vec3 p) {
    std::uint32_t found = NodeTree::kNoNode;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
        const Bounds& b = tree.node(i).bounds;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool last = b.upper[axis] == tree.bounds().upper[axis];
            inside = inside && p[axis] >= b.lower[axis] &&
                     (p[axis] < b.upper[axis] || (last && p[axis] == b.upper[axis]));
        }
        if (!inside) continue;
        EXPECT_EQ(found, NodeTree::kNoNode) << "two nodes hold one point";
        found = i;
    }
    return found;
}

TEST(NodeTree, LocateFindsTheNodeWhoseBoxHoldsThePoint) {
    const NodeTree tree = filled_tree({.max_nodes = 500, .node_photons = 8}, 3000, 1);
    EXPECT_GT(tree.node_count(), 200u);
    RandomStream random(2, 0, 0, RandomDomain::Eye);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = random_point(random);
        ASSERT_EQ(tree.locate(p), brute_force_locate(tree, p));
    }
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {  // corners lie exactly on split planes
        const Vec3 p = tree.node(i).bounds.lower;
        ASSERT_EQ(tree.locate(p), i);
    }
}

TEST(NodeTree, PhotonsLieInTheirNodes) {
    const NodeTree tree = filled_tree({.max_nodes = 5000, .node_photons = 8}, 3000, 3);
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
        count += tree.node(i).values.count;
        EXPECT_LE(tree.photons(i).size(), 8u);
        double sum = 0;
        for (const NodePhoton& photon : tree.photons(i)) {
            ASSERT_EQ(tree.locate(photon.position), i);
            sum += double(photon.value);
        }
        if (!tree.photons(i).empty()) {
            EXPECT_NEAR(tree.node(i).values.mean, sum / double(tree.photons(i).size()), 1e-6);
        }
    }
    EXPECT_EQ(count, 3000u);
}

TEST(NodeTree, PointsOutsideTheBoxFindANode) {
    const NodeTree tree = filled_tree({}, 3000, 4);
    const float inf = std::numeric_limits<float>::infinity();
    for (const Vec3 p : {Vec3{-5, 2, 9}, Vec3{inf, -inf, 0}, Vec3{std::nanf(""), 0, 0}}) {
        EXPECT_LT(tree.locate(p), tree.node_count());
    }
}

TEST(NodeTree, IsAFunctionOfTheCalls) {
    const NodeTree a = filled_tree({}, 5000, 5), b = filled_tree({}, 5000, 5);
    ASSERT_EQ(a.node_count(), b.node_count());
    for (std::uint32_t i = 0; i < a.node_count(); ++i) {
        EXPECT_EQ(a.node(i).bounds.lower, b.node(i).bounds.lower);
        EXPECT_EQ(a.node(i).values.squared_deviations, b.node(i).values.squared_deviations);
    }
}

// Eq. 7: shares of all eye rays, those that hit nothing included, summed over passes.
TEST(NodeTree, EyeRaysAddTheirShareToTheWeights) {
    NodeTree tree(kUnit, {.max_nodes = 2, .node_photons = 2});
    for (const float x : {0.1f, 0.2f, 0.8f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    const std::vector<Vec3> ends{{0.05f, 0, 0}, {0.9f, 0, 0}, {0.9f, 1, 1}, {std::nanf(""), 0, 0}};
    tree.add_eye_rays(ends, 8);
    EXPECT_DOUBLE_EQ(tree.node(0).weight, 1.0 / 8);
    EXPECT_DOUBLE_EQ(tree.node(1).weight, 2.0 / 8);
    tree.add_eye_rays(ends, 4);
    EXPECT_DOUBLE_EQ(tree.node(1).weight, 2.0 / 8 + 2.0 / 4);
    tree.add_eye_rays({}, 0);
    EXPECT_DOUBLE_EQ(tree.node(0).weight, 1.0 / 8 + 1.0 / 4);
}

TEST(NodeTree, ChildrenInheritWeightAndErrors) {
    NodeTree tree(kUnit, {.max_nodes = 8, .node_photons = 2});
    tree.add_eye_rays(std::vector<Vec3>{{0.5f, 0.5f, 0.5f}}, 2);
    tree.insert({0.1f, 0, 0}, 1);
    tree.insert({0.9f, 0, 0}, 1);
    tree.update_errors(CountCriterion{}, false);
    tree.end_pass();
    const double error = tree.node(0).error;
    EXPECT_DOUBLE_EQ(error, 2);
    for (const float x : {0.1f, 0.5f, 0.9f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    for (std::uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(tree.node(i).weight, 0.5);
        EXPECT_EQ(tree.node(i).error, error);
        EXPECT_EQ(tree.node(i).last_error, error);
        EXPECT_TRUE(tree.node(i).has_last_error);
        EXPECT_EQ(tree.node(i).depth, 1u);
        EXPECT_EQ(tree.node(i).parent, 0u);
    }
}

TEST(NodeTree, EndOfPassKeepsStructureWeightsAndErrors) {
    NodeTree tree = filled_tree({.node_photons = 8}, 2000, 6);
    tree.update_errors(CountCriterion{}, false);
    const std::uint32_t nodes = tree.node_count();
    std::vector<double> errors;
    for (std::uint32_t i = 0; i < nodes; ++i)
        errors.push_back(tree.node(i).error);
    tree.end_pass();
    ASSERT_EQ(tree.node_count(), nodes);
    for (std::uint32_t i = 0; i < nodes; ++i) {
        EXPECT_TRUE(tree.photons(i).empty());
        EXPECT_EQ(tree.node(i).values.count, 0u);
        EXPECT_EQ(tree.node(i).error, errors[i]);
        EXPECT_EQ(tree.node(i).last_error, errors[i]);
    }
}

TEST(NodeTree, UpdatesOnlyChangedNodesWhenAsked) {
    NodeTree tree(kUnit, {.max_nodes = 2, .node_photons = 2});
    for (const float x : {0.1f, 0.2f, 0.8f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    tree.update_errors(CountCriterion{}, true);
    const double untouched = tree.node(0).error;
    EXPECT_GT(untouched, 0);
    tree.insert({0.9f, 0.5f, 0.5f}, 1);
    const double before = tree.node(1).error;
    tree.update_errors(CountCriterion{}, true);
    EXPECT_GT(tree.node(1).error, before);
    EXPECT_EQ(tree.node(0).error, untouched);
    tree.update_errors(NanCriterion{}, false);  // refused
    EXPECT_EQ(tree.node(0).error, untouched);
}

/// A region keeps its name and its points when it splits, and has the mean error of its halves.
TEST(NodeTree, RegionsOutliveTheirNodes) {
    NodeTree tree(kUnit, {.max_nodes = 64, .node_photons = 2});
    RandomStream random(4, 0, 0, RandomDomain::Photon);
    const auto point = [&] { return Vec3{random.next(), random.next(), random.next()}; };
    while (tree.node_count() < 8)
        tree.insert(point(), 1);
    const Vec3 somewhere{0.3f, 0.6f, 0.4f};
    const std::uint32_t region = tree.region(somewhere), node = tree.locate(somewhere);
    const Bounds box = tree.node(node).bounds;
    while (tree.node(node).bounds.upper == box.upper)
        tree.insert(box.lower + (box.upper - box.lower) * random.next(), 1);
    EXPECT_NE(tree.region(somewhere), region);

    std::uint32_t next = 0;
    struct ErrorByTurn final : ErrorCriterion {
        explicit ErrorByTurn(std::uint32_t& turn) : turn_(turn) {}
        double error(const NodeView&) const override { return double(++turn_); }
        std::uint32_t& turn_;
    };
    tree.update_errors(ErrorByTurn(next), false);
    std::vector<double> errors;
    tree.region_errors(errors);
    ASSERT_EQ(errors.size(), tree.region_count());
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = point();
        EXPECT_EQ(errors[tree.region(p)], tree.node(tree.locate(p)).error);
    }
    // It has split once: into itself and the newest node.
    const double halves = tree.node(node).error + tree.node(tree.node_count() - 1).error;
    EXPECT_EQ(errors[region], halves / 2);
}

TEST(NodeTree, FlatNodesHaveAVolume) {
    const NodeTree tree(Bounds{{0, 0, 0}, {3, 4, 0}}, {});
    EXPECT_NEAR(tree.volume(0), 3 * 4 * (5 * 1e-3), 1e-6);
    EXPECT_EQ(NodeTree(Bounds{}, {}).volume(0), 0);
}

TEST(NodeTree, MemoryStaysWithinItsBoundOverPasses) {
    const NodeTreeSettings settings{.max_nodes = 300, .node_photons = 16};
    NodeTree tree(kUnit, settings);
    RandomStream random(7, 0, 0, RandomDomain::Photon);
    std::size_t full = 0;
    for (int pass = 0; pass < 20; ++pass) {
        for (int i = 0; i < 10000; ++i)
            tree.insert(random_point(random), random.next());
        tree.add_eye_rays(std::vector<Vec3>{{0.5f, 0.5f, 0.5f}}, 1);
        tree.end_pass();
        ASSERT_LE(tree.node_count(), settings.max_nodes);
        ASSERT_LE(tree.memory_bytes(), NodeTree::memory_bound_bytes(settings));
        if (pass == 0) full = tree.memory_bytes();
    }
    EXPECT_EQ(tree.memory_bytes(), full);
    EXPECT_EQ(tree.node_count(), 300u);
}

TEST(NodeTree, RefusesBadSettings) {
    EXPECT_THROW(NodeTree(kUnit, {.max_nodes = 0}), std::invalid_argument);
    EXPECT_THROW(NodeTree(kUnit, {.node_photons = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace aips::kd_tree_test
