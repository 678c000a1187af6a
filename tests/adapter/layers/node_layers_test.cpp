// Protects the views of the guide's nodes: edges where the kd-tree has them, weights and errors of
// the pixel's own node, bounces counted by node through splits.
#include "layers/node_layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aips/core/sampling/random.h"
#include "guides/paper/paper_guide.h"
#include "mock_camera.h"

namespace aips::node_layers_test {
namespace {

constexpr std::uint32_t kSize = 12;

Bounds unit_box() {
    Bounds box;
    box.extend(Vec3{0, 0, 0});
    box.extend(Vec3{1, 1, 1});
    return box;
}

Settings tiny_tree() {
    Settings settings;
    settings.node_photons = 4;
    settings.max_nodes = 6;
    return settings;
}

std::vector<Photon> photons_on_floor(std::uint64_t seed) {
    std::vector<Photon> photons;
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 40; ++i) {
        const Vec2 u = random.next2();
        Photon photon;
        photon.position = {u.x, u.y * u.y, 0};
        photon.previous = {0.5f, 0.5f, 1};
        photon.direction = normalize(photon.previous - photon.position);
        const float power = 0.5f + random.next();
        photon.power = {power, power, power};
        photons.push_back(photon);
    }
    return photons;
}

/// One visible point in the middle of each pixel, on the floor [0,1]^2; none in the first pixel.
EyeImage floor_from_above() {
    EyeImage image;
    for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
        const std::uint32_t column = i % kSize, row = i / kSize;
        const float x = float(column) + 0.5f, y = float(row) + 0.5f;
        image.positions.push_back({x, y});
        if (i == 0) continue;
        VisiblePoint point;
        point.position = {x / float(kSize), y / float(kSize), 0};
        point.sample = i;
        image.visible_points.push_back(point);
    }
    return image;
}

/// The node whose box holds `p`, found without the tree's own descent; kNoGuideNode for pixel 0.
std::vector<std::uint32_t> nodes_by_boxes(const NodeTree& tree) {
    std::vector<std::uint32_t> nodes(std::size_t{kSize} * kSize, kNoGuideNode);
    for (std::uint32_t i = 1; i < nodes.size(); ++i) {
        const std::uint32_t column = i % kSize, row = i / kSize;
        const float x = (float(column) + 0.5f) / float(kSize);
        const float y = (float(row) + 0.5f) / float(kSize);
        for (std::uint32_t n = 0; n < tree.node_count(); ++n) {
            const Bounds& box = tree.node(n).bounds;
            if (x >= box.lower.x && x < box.upper.x && y >= box.lower.y && y < box.upper.y &&
                box.lower.z <= 0) {
                nodes[i] = n;
            }
        }
    }
    return nodes;
}

TEST(NodeLayers, ShowTheTreeAtTheVisiblePoints) {
    PaperGuide guide(unit_box(), tiny_tree());
    const EyeImage image = floor_from_above();
    std::vector<Vec3> eye;
    positions_of(image.visible_points, eye);
    BounceStatistics bounces(guide, 6);
    guide.begin_pass(eye, image.positions.size());
    bounces.begin_pass();
    guide.update(photons_on_floor(3), {});
    bounces.follow_splits();
    const NodeTree& tree = guide.tree();
    ASSERT_GE(tree.node_count(), 4u);

    mock::Film film(kSize, kSize);
    NodeLayers layers(film, guide);
    std::vector<std::uint32_t> pixels(std::size_t{kSize} * kSize);
    for (std::uint32_t i = 0; i < pixels.size(); ++i)
        pixels[i] = i;
    layers.show(image, pixels, bounces);

    const auto nodes = nodes_by_boxes(tree);
    const auto differs = [&](std::size_t a, std::size_t b) {
        return nodes[a] != nodes[b] && nodes[a] != kNoGuideNode && nodes[b] != kNoGuideNode;
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::size_t x = i % kSize, y = i / kSize;
        const bool edge = (x > 0 && differs(i, i - 1)) || (x + 1 < kSize && differs(i, i + 1)) ||
                          (y > 0 && differs(i, i - kSize)) ||
                          (y + 1 < kSize && differs(i, i + kSize));
        EXPECT_EQ(film.layers().at("nodeedges")[i], edge ? 1 : 0) << "pixel " << x << " " << y;
        const bool has = nodes[i] != kNoGuideNode;
        EXPECT_EQ(film.layers().at("nodeweight")[i], has ? float(tree.node(nodes[i]).weight) : 0);
        EXPECT_EQ(film.layers().at("nodeerror")[i], has ? float(tree.node(nodes[i]).error) : 0);
    }
}

/// A row's end and the next row's start are no neighbours; one node has no edges.
TEST(NodeEdges, AreBetweenNeighbours) {
    const std::vector<std::uint32_t> nodes{7, 7, 1,  //
                                           7, 7, 1,  //
                                           1, 1, kNoGuideNode};
    std::vector<float> edges(9, 5.0f);
    find_node_edges(nodes, 3, edges);
    EXPECT_EQ(edges, (std::vector<float>{0, 1, 1, 1, 1, 1, 1, 1, 0}));
    const std::vector<std::uint32_t> stripes{1, 2, 2, 1};
    edges.resize(4);
    find_node_edges(stripes, 4, edges);
    EXPECT_EQ(edges, (std::vector<float>{1, 1, 1, 1}));
    find_node_edges(std::vector<std::uint32_t>(4, 2), 2, edges);
    EXPECT_EQ(edges, (std::vector<float>{0, 0, 0, 0}));
}

TEST(BounceStatistics, ChildrenShareTheirParentsCounts) {
    PaperGuide guide(unit_box(), tiny_tree());
    BounceStatistics bounces(guide, 6);
    const Vec3 corner{0.05f, 0.02f, 0};
    guide.begin_pass(std::vector<Vec3>{corner}, 1);
    bounces.begin_pass();
    EXPECT_EQ(bounces.guided_share(0), 0) << "no bounce, no share";
    constexpr int kBounces = 256;  // can be halved by every split that this tree makes
    for (int i = 0; i < kBounces; ++i)
        bounces.count({0.9f, 0.9f, 0}, i % 4 == 0);
    guide.update(photons_on_floor(3), {});
    bounces.follow_splits();
    const auto count = std::uint32_t(guide.statistics().nodes);
    ASSERT_GE(count, 4u);
    for (std::uint32_t node = 0; node < count; ++node)
        EXPECT_EQ(bounces.guided_share(node), 0.25f) << node;

    const std::uint32_t mine = guide.node_at(corner);
    bounces.count(corner, true);
    const double inherited = kBounces / std::exp2(double(guide.tree().node(mine).depth));
    EXPECT_EQ(bounces.guided_share(mine), float((inherited / 4 + 1) / (inherited + 1)));
    for (std::uint32_t node = 0; node < count; ++node)
        EXPECT_TRUE(node == mine || bounces.guided_share(node) == 0.25f) << node;
    bounces.begin_pass();
    EXPECT_EQ(bounces.guided_share(mine), 0);
    EXPECT_LE(bounces.memory_bytes(), BounceStatistics::memory_bound_bytes(6));
}

}  // namespace
}  // namespace aips::node_layers_test
