// Protects: the trees over a scene stop and keep every photon, whatever its place: on a splitting
// plane, all at one point, on lines and planes, in scenes of 1e-6 to 1e6 units far from the origin;
// what has no place is refused.
#include <gtest/gtest.h>

#include "aips/core/tables/bounce_tables.h"
#include "aips/core/tables/paper_tables.h"
#include "aips/core/trees/kd_tree.h"
#include "aips/core/trees/primary_tree.h"
#include "aips/core/trees/score_cache.h"
#include "point_clouds.h"
#include "stress_case.h"

namespace degenerate_trees_test {
namespace {

using namespace aips;
using namespace stress;

constexpr Vec3 kUp{0, 0, 1};
const NodeTreeSettings kNodes{.max_nodes = 512, .node_photons = 8};

/// In the half-open sense of splits; the scene's upper faces belong to the last nodes.
bool holds(const Node& node, const Bounds& scene, Vec3 p) {
    for (int axis = 0; axis < 3; ++axis) {
        const bool at_end = node.bounds.upper[axis] >= scene.upper[axis];
        if (node.bounds.lower[axis] > scene.lower[axis] && p[axis] < node.bounds.lower[axis])
            return false;
        if (!at_end && p[axis] >= node.bounds.upper[axis]) return false;
    }
    return true;
}

void expect_whole(const NodeTree& tree, const std::vector<Vec3>& points) {
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
        count += tree.node(i).values.count;
        ASSERT_TRUE(tree.volume(i) >= 0 && std::isfinite(tree.volume(i)));
        ASSERT_TRUE(tree.node(i).error >= 0 && std::isfinite(tree.node(i).error));
        for (const NodePhoton& photon : tree.photons(i))
            ASSERT_EQ(tree.locate(photon.position), i);
    }
    EXPECT_EQ(count, points.size());
    for (const Vec3 p : points)
        ASSERT_TRUE(holds(tree.node(tree.locate(p)), tree.bounds(), p));
}

TEST(StressNodeTree, KeepsEveryPhotonOfEveryCloud) {
    const auto all = clouds(sized(2000, 50000));
    std::uint32_t most = 0;
    for (const Placement& placement : placements()) {
        for (const Cloud& cloud : all) {
            SCOPED_TRACE(cloud.name + ", " + placement.name());
            const std::vector<Vec3> points = placement.place(cloud.points);
            NodeTree tree(placement.box(), kNodes);
            tree.add_eye_rays(points, points.size());
            for (const Vec3 p : points)
                ASSERT_NE(tree.insert(p, 1), NodeTree::kNoNode);
            tree.update_errors(PaperErrorCriterion(), false);
            expect_whole(tree, points);
            ASSERT_LE(tree.node_count(), kNodes.max_nodes);
            if (cloud.name == "one point") {
                ASSERT_EQ(tree.node_count(), 1u);
            }
            if (cloud.name == "two points") {
                ASSERT_LE(tree.node_count(), 2u);
            }
            most = std::max(most, tree.node_count());
        }
    }
    record("10 clouds in 15 placements, at most 512 nodes of 8 photons",
           "every photon in its node's box, at most " + std::to_string(most) + " nodes");
}

TEST(StressNodeTree, PhotonsOnSplittingPlanesBelongToOneNode) {
    const Cloud box = clouds(4000).back();
    NodeTree tree(Placement{}.box(), {.max_nodes = 256, .node_photons = 8});
    for (const Vec3 p : box.points)
        tree.insert(p, 1);
    std::uint64_t tried = 0;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
        const Bounds bounds = tree.node(i).bounds;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p{(corner & 1 ? bounds.upper : bounds.lower).x,
                         (corner & 2 ? bounds.upper : bounds.lower).y,
                         (corner & 4 ? bounds.upper : bounds.lower).z};
            int holding = 0;
            for (std::uint32_t k = 0; k < tree.node_count(); ++k)
                holding += holds(tree.node(k), tree.bounds(), p);
            ASSERT_EQ(holding, 1);
            const std::uint32_t node = tree.insert(p, 1);
            ASSERT_TRUE(holds(tree.node(node), tree.bounds(), p));
            ++tried;
        }
    }
    record("photons at all corners of 256 nodes, on up to three planes each",
           std::to_string(tried) + " photons, each in exactly one node");
}

/// Powers of two scale floats without rounding: the tree has to be the same.
TEST(StressNodeTree, IsTheSameAtEveryScale) {
    const Cloud box = clouds(3000).back();
    NodeTree plain(Placement{}.box(), kNodes);
    for (const Vec3 p : box.points)
        plain.insert(p, 1);
    for (const float scale : {0x1p-60f, 0x1p-20f, 0x1p20f, 0x1p60f}) {
        const Placement placement{scale, 0};
        NodeTree scaled(placement.box(), kNodes);
        for (const Vec3 p : box.points)
            scaled.insert(placement.place(p), 1);
        ASSERT_EQ(scaled.node_count(), plain.node_count());
        for (std::uint32_t i = 0; i < plain.node_count(); ++i) {
            ASSERT_EQ(scaled.node(i).bounds.lower, plain.node(i).bounds.lower * scale);
            const double cube = double(scale) * double(scale) * double(scale);
            ASSERT_NEAR(scaled.volume(i) / (cube * plain.volume(i)), 1, 1e-12);
        }
    }
    record("3000 photons scaled by 2^-60 to 2^60", "nodes the same to the bit");
}

TEST(StressScoreCache, StopsAtEveryCloud) {
    const auto all = clouds(sized(500, 2000));
    const int updates = sized(40, 400);
    std::uint32_t most = 0;
    for (const Placement& placement : placements()) {
        for (const Cloud& cloud : all) {
            SCOPED_TRACE(cloud.name + ", " + placement.name());
            const std::vector<Vec3> points = placement.place(cloud.points);
            ScoreCache cache(placement.box(), {.max_leaves = 1024});
            for (int u = 0; u < updates; ++u) {
                for (const Vec3 p : points)
                    ASSERT_TRUE(cache.add({p, kUp, 1, 2}));
                cache.update(double(points.size()));
            }
            for (const Vec3 p : points) {
                ASSERT_NEAR(cache.at(p, kUp).score, 1, 1e-5);
                ASSERT_NEAR(cache.at(p, kUp).cost, 2, 1e-5);
            }
            if (cloud.name == "one point" || cloud.name == "two points") {
                ASSERT_LE(cache.leaf_count(), 6u + 24u);
                most = std::max(most, cache.leaf_count());
            }
        }
    }
    record(std::to_string(updates) + " updates of 10 clouds in 15 placements",
           "means kept; one or two points: at most " + std::to_string(most) + " of 1024 leaves");
}

/// Far from the origin no plane lies between neighbouring floats: each split there would leave one
/// of its halves as it was, and take a leaf.
TEST(StressScoreCache, StopsBetweenNeighbouringFloats) {
    std::uint32_t most = 0;
    for (int shift = 0; shift < 4; ++shift) {
        float low = 1e6f;
        for (int i = 0; i < shift; ++i)
            low = std::nextafter(low, 2e6f);
        const float high = std::nextafter(low, 2e6f);
        ScoreCache cache(Bounds{{1e6f, 1e6f, 1e6f}, {1e6f + 1, 1e6f + 1, 1e6f + 1}});
        for (int u = 0; u < 300; ++u) {
            for (int i = 0; i < 200; ++i) {
                cache.add({{i & 1 ? low : high, i & 2 ? low : high, i & 4 ? low : high},
                           kUp,
                           i & 1 ? 1.0 : 2.0,
                           1});
            }
            cache.update(200);
        }
        EXPECT_LE(cache.leaf_count(), 6u + 8u);
        EXPECT_NEAR(cache.at({low, low, low}, kUp).score, 1, 1e-5);
        EXPECT_NEAR(cache.at({high, low, low}, kUp).score, 2, 1e-5);
        most = std::max(most, cache.leaf_count());
    }
    record("300 updates with all vertices at two neighbouring floats an axis, at 1e6 units",
           std::to_string(most) + " leaves of at most 14");
}

TEST(StressPrimaryTree, StopsAtOnePointAndOnFaces) {
    for (const PrimaryPoint point :
         {PrimaryPoint{0, 0, 0, 0}, PrimaryPoint{0x1.fffffep-1f, 0x1.fffffep-1f, 0.5f, 0.25f},
          PrimaryPoint{0.5f, 0.5f, 0.5f, 0.5f}}) {
        PrimaryTree tree({.max_leaves = 4096, .split_count = 1});
        for (int u = 0; u < 300; ++u) {
            tree.add(point, 1);
            tree.update(1);
            tree.set_mixture({0.15, 0});
        }
        // 20 halvings of four sides.
        EXPECT_LE(tree.leaf_count(), 81u);
        EXPECT_TRUE(std::isfinite(tree.pdf(point)));
        EXPECT_GT(tree.pdf(point), 1e5f);
    }
    record("300 updates with all scores at one point, in corners and on planes",
           "at most 81 leaves, 20 halvings an axis");
}

TEST(StressTrees, RefuseWhatHasNoPlace) {
    const Bounds box = Placement{}.box();
    NodeTree nodes(box, kNodes);
    ScoreCache scores(box);
    BounceTables bounces(box);
    PaperTables tables({});
    std::vector<Photon> photons;
    for (const Vec3 p : impossible_points()) {
        EXPECT_EQ(nodes.insert(p, 1), NodeTree::kNoNode);
        EXPECT_FALSE(scores.add({p, kUp, 1, 1}));
        EXPECT_FALSE(scores.add({{0, 0, 0}, p, 1, 1}));
        EXPECT_FALSE(bounces.add({p, kUp, kUp, 1, 1, 1, 1, 1}));
        EXPECT_FALSE(bounces.add({{0, 0, 0}, kUp, p, 1, 1, 1, 1, 1}));
        EXPECT_LT(nodes.locate(p), nodes.node_count());
        EXPECT_FALSE(scores.at(p, kUp).known);
        for (Vec3 Photon::*place : {&Photon::position, &Photon::previous, &Photon::direction}) {
            Photon photon;
            photon.depth = 2;
            photon.direction = kUp;
            photon.*place = p;
            photons.push_back(photon);
        }
    }
    nodes.add_eye_rays(impossible_points(), 10);
    EXPECT_EQ(nodes.node(0).weight, 0);
    EXPECT_EQ(nodes.node(0).values.count, 0u);
    tables.update(nodes, photons);
    for (const float e : tables.relative_error(0))
        EXPECT_EQ(e, 1);
    record("NaN and infinite positions, normals and directions", "refused by all four");
}

/// A box that no float can hold the width of.
TEST(StressTrees, StopInTheWidestBox) {
    const float most = std::numeric_limits<float>::max();
    const Bounds box{{-most, -most, -most}, {most, most, most}};
    const Placement placement{most, 0};
    NodeTree nodes(box, kNodes);
    ScoreCache scores(box, {.max_leaves = 256});
    const Cloud cloud = clouds(2000).back();
    for (int u = 0; u < 20; ++u) {
        for (const Vec3 p : cloud.points) {
            const Vec3 q = placement.place(p * 2 - Vec3{1, 1, 1});
            nodes.insert(q, 1);
            scores.add({q, kUp, 1, 1});
        }
        scores.update(2000);
    }
    EXPECT_GT(nodes.node_count(), 100u);
    for (std::uint32_t i = 0; i < nodes.node_count(); ++i)
        ASSERT_TRUE(std::isfinite(nodes.volume(i)));
    EXPECT_NEAR(scores.at({0, 0, 0}, kUp).score, 1, 1e-5);
    record("a scene of +-3.4e38", std::to_string(nodes.node_count()) + " nodes, finite volumes");
}

}  // namespace
}  // namespace degenerate_trees_test
