// Protects the range query: exactly the photons within the radius, each once, whatever the hash
// collisions, signs, and sizes of the coordinates.
#include "aips/core/photon_map/photon_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::photon_grid_test {
namespace {

std::vector<Photon> scattered(std::size_t count, Vec3 center, float spread, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    std::vector<Photon> photons(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 u = random.next2();
        photons[i].position =
            center + Vec3{u.x - 0.5f, u.y - 0.5f, random.next() - 0.5f} * (2 * spread);
        photons[i].path = std::uint32_t(i);
    }
    return photons;
}

/// Visits by path number, -1 a photon that is not within the radius.
void expect_like_brute_force(const PhotonGrid& grid, std::span<const Photon> photons, Vec3 p,
                             float radius) {
    std::vector<int> visits(photons.size());
    grid.for_each_in_radius(p, radius, [&](const GridPhoton& photon) { ++visits[photon.index]; });
    const float reach = std::min(radius, grid.radius());
    for (std::size_t i = 0; i < photons.size(); ++i) {
        const bool inside = length_squared(photons[i].position - p) <= reach * reach;
        ASSERT_EQ(visits[i], inside ? 1 : 0) << "photon " << i;
    }
}

struct Case {
    const char* name;
    std::size_t count;
    Vec3 center;
    float spread, radius;
};

class GridCase : public testing::TestWithParam<Case> {};

TEST_P(GridCase, FindsWhatBruteForceFinds) {
    const Case& c = GetParam();
    const auto photons = scattered(c.count, c.center, c.spread, 1);
    PhotonGrid grid;
    // Few and many queries: with a filter before them, and without.
    for (const std::size_t expected : {std::size_t{0}, 9 * photons.size(), std::size_t{0}}) {
        grid.build(photons, c.radius, serial_for, expected);
        EXPECT_EQ(grid.size(), photons.size());
        const auto queries = scattered(300, c.center, 1.1f * c.spread, 2);
        for (const Photon& q : queries) {
            expect_like_brute_force(grid, photons, q.position, c.radius);
            expect_like_brute_force(grid, photons, q.position, 0.3f * c.radius);
        }
        for (std::size_t i = 0; i < std::min<std::size_t>(50, photons.size()); ++i) {
            expect_like_brute_force(grid, photons, photons[i].position, c.radius);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, GridCase,
    testing::Values(Case{"AroundZero", 2000, {0, 0, 0}, 1, 0.1f},
                    Case{"Negative", 2000, {-50, -20, -70}, 1, 0.1f},
                    Case{"TinyTable", 3, {0, 0, 0}, 1, 1},  // four buckets: nearly all collide
                    Case{"OnePhoton", 1, {0, 0, 0}, 0.1f, 1},
                    Case{"RadiusOfTheScene", 200, {0, 0, 0}, 1, 5},
                    Case{"FarFromTheOrigin", 500, {1e6f, -1e6f, 1e6f}, 10, 1},
                    Case{"HugeInCells", 100, {3e30f, -3e30f, 1e30f}, 1e29f, 1e-3f},
                    Case{"TinyScene", 1000, {0, 0, 0}, 1e-12f, 1e-13f}),
    [](const auto& instance) { return std::string(instance.param.name); });

// Truncation would make the cells at zero twice as wide, and miss or double what lies there.
TEST(PhotonGrid, PhotonsExactlyOnCellFacesAndAtTheRadius) {
    std::vector<Photon> photons;
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            for (int z = -3; z <= 3; ++z) {
                Photon l;
                l.position = {float(x), float(y), float(z)};
                l.path = std::uint32_t(photons.size());
                photons.push_back(l);
            }
        }
    }
    for (const float radius : {0.5f, 1.0f, 2.0f}) {
        PhotonGrid grid;
        grid.build(photons, radius);
        for (const Photon& l : photons) {
            expect_like_brute_force(grid, photons, l.position, radius);
        }
        expect_like_brute_force(grid, photons, {0.5f, 0.5f, 0.5f}, radius);
    }
}

TEST(PhotonGrid, OrderIsAFunctionOfThePhotons) {
    const auto photons = scattered(5000, {0, 0, 0}, 1, 3);
    PhotonGrid first, second;
    second.build(scattered(9000, {2, 2, 2}, 3, 4), 0.7f);
    first.build(photons, 0.2f);
    second.build(photons, 0.2f);
    const auto visits = [](const PhotonGrid& grid) {
        std::vector<std::uint32_t> order;
        grid.for_each_in_radius({0.1f, 0, 0}, 0.2f,
                                [&](const GridPhoton& p) { order.push_back(p.index); });
        return order;
    };
    EXPECT_FALSE(visits(first).empty());
    EXPECT_EQ(visits(first), visits(second));
}

// The sums of a gather run in the grid's order: it must not depend on who sorted which part.
TEST(PhotonGrid, SameOrderHoweverItsJobsAreRun) {
    const auto photons = scattered(50000, {0, 0, 0}, 1, 8);  // several chunks and partitions
    PhotonGrid forward, backward;
    forward.build(photons, 0.1f);
    backward.build(photons, 0.1f, [](std::uint32_t count, const Job& job) {
        for (std::uint32_t i = count; i-- > 0;)
            job(i);
    });
    const auto visits = [](const PhotonGrid& grid) {
        std::vector<std::uint32_t> order;
        grid.for_each_in_radius({0.1f, 0, 0}, 0.1f,
                                [&](const GridPhoton& p) { order.push_back(p.index); });
        return order;
    };
    EXPECT_GT(visits(forward).size(), 10u);
    EXPECT_EQ(visits(forward), visits(backward));
    expect_like_brute_force(forward, photons, {0.1f, 0, 0}, 0.1f);
}

TEST(PhotonGrid, CopiesWhatAGatherNeeds) {
    Photon photon;
    photon.position = {1, 2, 3};
    photon.direction = {0, 0, 1};
    photon.power = {4, 5, 6};
    photon.normal = {0, 0.6f, -0.8f};
    photon.light_group = 7;
    PhotonGrid grid;
    grid.build({&photon, 1}, 1);
    int visits = 0;
    grid.for_each_in_radius({1, 2, 3}, 1, [&](const GridPhoton& p) {
        ++visits;
        EXPECT_EQ(p.position, photon.position);
        EXPECT_EQ(p.direction, photon.direction);
        EXPECT_EQ(p.power, photon.power);
        EXPECT_EQ(p.normal, -photon.normal) << "of the side that the photon came from";
        EXPECT_EQ(p.light_group, 7u);
    });
    EXPECT_EQ(visits, 1);
}

TEST(PhotonGrid, LeavesOutWhatIsNotFinite) {
    auto photons = scattered(10, {0, 0, 0}, 0.1f, 5);
    photons[3].position.x = std::numeric_limits<float>::quiet_NaN();
    photons[4].position.y = std::numeric_limits<float>::infinity();
    PhotonGrid grid;
    grid.build(photons, 1);
    EXPECT_EQ(grid.size(), 8u);
    int visits = 0;
    const auto count = [&](const GridPhoton&) { ++visits; };
    grid.for_each_in_radius({0, 0, 0}, 1, count);
    EXPECT_EQ(visits, 8);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    grid.for_each_in_radius({nan, 0, 0}, 1, count);
    grid.for_each_in_radius({0, 0, 0}, -1, count);
    grid.for_each_in_radius({0, 0, 0}, nan, count);
    EXPECT_EQ(visits, 8);
}

TEST(PhotonGrid, EmptyAndBadRadius) {
    PhotonGrid grid;
    int visits = 0;
    const auto count = [&](const GridPhoton&) { ++visits; };
    grid.for_each_in_radius({0, 0, 0}, 1, count);
    grid.build({}, 1);
    grid.for_each_in_radius({0, 0, 0}, 1, count);
    EXPECT_EQ(visits, 0);
    const auto photons = scattered(5, {1, 1, 1}, 0.5f, 6);
    for (const float radius : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity()}) {
        grid.build(photons, radius);
        visits = 0;
        grid.for_each_in_radius(photons[2].position, grid.radius(), count);
        EXPECT_GE(visits, 1);
    }
}

TEST(PhotonGrid, ReusesItsMemoryWithinTheBound) {
    PhotonGrid grid;
    const auto many = scattered(3000, {0, 0, 0}, 1, 7);
    grid.build(many, 0.1f);
    const std::size_t bytes = grid.memory_bytes();
    EXPECT_LE(bytes, PhotonGrid::memory_bound_bytes(3000));
    for (std::size_t n : {10u, 2999u, 1u, 3000u}) {
        grid.build(std::span(many).first(n), 0.05f);
        EXPECT_EQ(grid.memory_bytes(), bytes);
    }
}

}  // namespace
}  // namespace aips::photon_grid_test
