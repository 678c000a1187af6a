// Protects the splits of the kd-tree: the median along the longest side, and the degenerate
// arrangements of photons that must neither loop nor lose photons.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/trees/kd_tree.h"

namespace aips::kd_tree_split_test {
namespace {

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};
constexpr Bounds kFlatBox{{0, 0, 0}, {4, 2, 1}};

std::uint64_t photons_counted(const NodeTree& tree) {
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i)
        count += tree.node(i).values.count;
    return count;
}

TEST(NodeTreeSplit, AtTheMedianOfTheLongestSide) {
    NodeTree tree(kFlatBox, {.node_photons = 4});
    for (const float x : {0.1f, 0.2f, 0.3f, 3.0f, 3.5f})
        tree.insert({x, 1, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    EXPECT_FLOAT_EQ(tree.node(0).bounds.upper.x, 0.25f);  // between the second and the third
    EXPECT_EQ(tree.node(0).bounds.upper.x, tree.node(1).bounds.lower.x);
    EXPECT_EQ(tree.photons(0).size(), 2u);
    EXPECT_EQ(tree.photons(1).size(), 3u);
}

TEST(NodeTreeSplit, HoldsItsCapacityBeforeSplitting) {
    NodeTree tree(kUnit, {.node_photons = 32});
    RandomStream random(1, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 32; ++i)
        tree.insert({random.next(), random.next(), random.next()}, 1);
    EXPECT_EQ(tree.node_count(), 1u);
    tree.insert({0.5f, 0.5f, 0.5f}, 1);
    EXPECT_EQ(tree.node_count(), 2u);
    EXPECT_EQ(tree.photons(0).size() + tree.photons(1).size(), 33u);
    EXPECT_EQ(std::min(tree.photons(0).size(), tree.photons(1).size()), 16u);
}

TEST(NodeTreeSplit, ManyPhotonsAtOnePointStayInOneNode) {
    NodeTree tree(kUnit, {.node_photons = 8});
    for (int i = 0; i < 10000; ++i)
        tree.insert({0.3f, 0.3f, 0.3f}, float(i % 3));
    EXPECT_EQ(tree.node_count(), 1u);
    EXPECT_EQ(tree.node(0).values.count, 10000u);
    EXPECT_NEAR(tree.node(0).values.mean, 1, 1e-3);
    EXPECT_LE(tree.photons(0).size(), 9u);
    tree.end_pass();  // the next pass may split it again
    for (int i = 0; i < 9; ++i)
        tree.insert({0.1f * float(i), 0.3f, 0.3f}, 1);
    EXPECT_EQ(tree.node_count(), 2u);
}

TEST(NodeTreeSplit, LinesAndPlanesAcrossTheLongestSideUseTheOtherAxes) {
    for (const int varying : {1, 2}) {
        NodeTree tree(kFlatBox, {.max_nodes = 100, .node_photons = 8});
        RandomStream random(2, 0, std::uint64_t(varying), RandomDomain::Photon);
        for (int i = 0; i < 2000; ++i) {
            Vec3 p{2, 0.5f, 0.5f};  // x, the longest axis, cannot separate
            p[varying] = random.next();
            tree.insert(p, 1);
        }
        EXPECT_EQ(tree.node_count(), 100u);
        EXPECT_EQ(photons_counted(tree), 2000u);
        for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
            EXPECT_EQ(tree.node(i).bounds.upper.x, 4);
        }
    }
}

TEST(NodeTreeSplit, PhotonsOnThePlaneGoWhereLocateFindsThem) {
    NodeTree tree(kUnit, {.node_photons = 4});
    for (const float x : {0.25f, 0.25f, 0.5f, 0.5f, 0.5f})
        tree.insert({x, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    const float plane = tree.node(1).bounds.lower.x;
    const std::uint32_t node = tree.insert({plane, 0.5f, 0.5f}, 1);
    EXPECT_EQ(node, 1u);
    EXPECT_EQ(tree.locate({plane, 0.5f, 0.5f}), 1u);
    EXPECT_EQ(tree.locate({std::nextafter(plane, 0.0f), 0.5f, 0.5f}), 0u);
}

// Neighbouring floats leave no room between them: the plane is the upper one.
TEST(NodeTreeSplit, SeparatesNeighbouringFloats) {
    NodeTree tree(kUnit, {.node_photons = 2});
    const float a = 0.5f, b = std::nextafter(a, 1.0f);
    for (const float x : {a, a, b})
        tree.insert({x, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    EXPECT_EQ(tree.photons(0).size(), 2u);
    EXPECT_EQ(tree.photons(1).size(), 1u);
}

TEST(NodeTreeSplit, EqualCoordinatesSplitAsNearTheMedianAsTheyCan) {
    NodeTree tree(kUnit, {.node_photons = 8});
    for (int i = 0; i < 7; ++i)
        tree.insert({0.75f, 0.5f, 0.5f}, 1);
    tree.insert({0.25f, 0.5f, 0.5f}, 1);
    tree.insert({0.5f, 0.5f, 0.5f}, 1);
    ASSERT_EQ(tree.node_count(), 2u);
    EXPECT_EQ(tree.photons(0).size(), 2u);
    EXPECT_EQ(tree.photons(1).size(), 7u);
}

TEST(NodeTreeSplit, DepthIsCapped) {
    NodeTree tree(kUnit, {.max_nodes = 1000, .node_photons = 2, .max_depth = 5});
    RandomStream random(3, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 20000; ++i) {
        tree.insert({std::pow(random.next(), 20.0f), random.next(), random.next()}, 1);
    }
    EXPECT_LE(tree.node_count(), 32u);
    for (std::uint32_t i = 0; i < tree.node_count(); ++i)
        EXPECT_LE(tree.node(i).depth, 5u);
    EXPECT_EQ(photons_counted(tree), 20000u);
}

TEST(NodeTreeSplit, OneNodeMeansNoSplits) {
    NodeTree tree(kUnit, {.max_nodes = 1, .node_photons = 2});
    RandomStream random(4, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 100; ++i)
        tree.insert({random.next(), random.next(), 0}, 1);
    EXPECT_EQ(tree.node_count(), 1u);
    EXPECT_EQ(tree.node(0).values.count, 100u);
}

TEST(NodeTreeSplit, RefusesPhotonsThatAreNoNumbers) {
    NodeTree tree(kUnit, {});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(tree.insert({nan, 0, 0}, 1), NodeTree::kNoNode);
    EXPECT_EQ(tree.insert({0, inf, 0}, 1), NodeTree::kNoNode);
    EXPECT_EQ(tree.insert({0, 0, 0}, nan), NodeTree::kNoNode);
    EXPECT_EQ(tree.insert({0, 0, 0}, inf), NodeTree::kNoNode);
    EXPECT_EQ(tree.insert({0, 0, 0}, -1), NodeTree::kNoNode);
    EXPECT_EQ(photons_counted(tree), 0u);
}

TEST(NodeTreeSplit, PhotonsOutsideTheBoxDoNotBreakIt) {
    NodeTree tree(kUnit, {.max_nodes = 50, .node_photons = 4});
    RandomStream random(5, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 5000; ++i) {
        tree.insert({4 * random.next() - 2, 4 * random.next() - 2, 1e30f * random.next()}, 1);
    }
    EXPECT_EQ(photons_counted(tree), 5000u);
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
        EXPECT_FALSE(tree.node(i).bounds.empty());
        EXPECT_GT(tree.volume(i), 0);
    }
}

}  // namespace
}  // namespace aips::kd_tree_split_test
