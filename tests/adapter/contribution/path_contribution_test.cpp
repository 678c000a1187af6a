// Protects what guides are told that a path's vertices contributed: the scores and costs of all
// that came after, and nothing of what came before.
#include "contribution/path_contribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace aips::path_contribution_test {
namespace {

/// Paths with photons of the scores 1, 2, 4, ... 128, 1, 2, ... in their order.
class PathContributionsTest : public ::testing::Test {
  protected:
    /// A path that met surfaces at the depths 1, 2, ... by a ray each and landed on all of them. At
    /// each but the last, `photons` went on.
    void add_path(const std::vector<float>& photons) {
        PathRecord path;
        path.first_vertex = std::uint32_t(log_.vertices.size());
        path.vertices = std::uint32_t(photons.size());
        path.first_photon = std::uint32_t(log_.photons.size());
        path.photons = path.rays = path.vertices + 1;
        for (std::uint32_t depth = 1; depth <= path.photons; ++depth) {
            Photon photon;
            photon.depth = std::uint16_t(depth);
            log_.photons.push_back(photon);
            scores_.push_back(std::ldexp(1.0, int(scores_.size() % 8)));
            if (depth == path.photons) continue;
            PathVertex vertex;
            vertex.depth = vertex.rays = depth;
            vertex.survival.photons = photons[depth - 1];
            log_.vertices.push_back(vertex);
        }
        log_.paths.push_back(path);
    }
    void measure() { contributions_.measure(log_, scores_); }
    void expect_contribution(const PathContribution& contribution, double score, double rays,
                             double landed) const {
        EXPECT_DOUBLE_EQ(contribution.score, score);
        EXPECT_DOUBLE_EQ(contribution.cost, rays + kPhotonCost * landed);
    }

    PathLog log_;
    std::vector<double> scores_;
    PathContributions contributions_;
};

TEST_F(PathContributionsTest, IsOfWhatCameAfter) {
    add_path({1, 0.5f});
    measure();
    expect_contribution(contributions_.vertices()[0], 2 + 4, 2, 2);
    expect_contribution(contributions_.vertices()[1], 4, 1, 1);
    expect_contribution(contributions_.paths()[0], 1 + 2 + 4, kPhotonCost + 3, 3);
}

// The first of the photons stands for all: before the split, what came after counts for each.
TEST_F(PathContributionsTest, OfSplitPhotonsCountsForEach) {
    add_path({1, 3});
    measure();
    expect_contribution(contributions_.vertices()[1], 4, 1, 1);
    expect_contribution(contributions_.vertices()[0], 2 + 3 * 4, 1 + 3, 1 + 3);
    expect_contribution(contributions_.paths()[0], 1 + 2 + 3 * 4, kPhotonCost + 2 + 3, 2 + 3);
}

TEST_F(PathContributionsTest, OfEachPathByItself) {
    add_path({});
    add_path({1});
    measure();
    expect_contribution(contributions_.paths()[0], 1, kPhotonCost + 1, 1);
    expect_contribution(contributions_.paths()[1], 2 + 4, kPhotonCost + 2, 2);
    ASSERT_EQ(contributions_.scores(log_.paths[1]).size(), 2u);
    EXPECT_EQ(contributions_.scores(log_.paths[1])[0], 2);
    // A later iteration's take their place.
    log_ = {};
    scores_.clear();
    add_path({1});
    measure();
    ASSERT_EQ(contributions_.paths().size(), 1u);
    ASSERT_EQ(contributions_.vertices().size(), 1u);
    expect_contribution(contributions_.vertices()[0], 2, 1, 1);
}

// More than one job takes.
TEST_F(PathContributionsTest, OfManyPathsInLittleMemory) {
    constexpr std::size_t kPaths = 600, kDepth = 7;
    for (std::size_t i = 0; i < kPaths; ++i)
        add_path(std::vector<float>(kDepth, 1));
    measure();
    ASSERT_EQ(contributions_.paths().size(), kPaths);
    for (std::size_t i = 0; i < kPaths; ++i) {
        expect_contribution(contributions_.paths()[i], 255, kPhotonCost + 8, 8);
        expect_contribution(contributions_.vertices()[i * kDepth], 254, 7, 7);
        expect_contribution(contributions_.vertices()[i * kDepth + 6], 128, 1, 1);
    }
    EXPECT_LE(contributions_.memory_bytes(), PathContributions::memory_bound_bytes(kPaths, kDepth));
}

}  // namespace
}  // namespace aips::path_contribution_test
