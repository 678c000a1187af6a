// Protects the choice of who brings caustics to glossy lobes: each place has its own, single bright
// photons and the cost of gathering count.
#include "aips/core/tables/gloss_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "aips/core/sampling/random.h"

namespace aips::gloss_table_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};
constexpr Vec3 kLeft{0.2f, 0.5f, 0}, kRight{0.8f, 0.5f, 0};

/// Of a pass of 100 photon paths: on the left bounces have nine times the variance of photons, on
/// the right a ninth.
GlossSample sample_at(RandomStream& random) {
    const bool left = random.next() < 0.5f;
    return {.position = {0.5f * random.next() + (left ? 0 : 0.5f), random.next(), 0},
            .normal = kUp,
            .weight = 1,
            .light = 1,
            .photons = 100 * (0.5 + double(random.next())),
            .bounce = left ? 9 : 1.0 / 9};
}

void learn(GlossTable& table, std::uint64_t round, int samples) {
    RandomStream random(1, round, 0, RandomDomain::Eye);
    for (int i = 0; i < samples; ++i)
        EXPECT_TRUE(table.add(sample_at(random)));
    table.update(std::size_t(samples));
}

TEST(GlossTable, EachPlaceHasItsOwn) {
    GlossTable table(kScene);
    EXPECT_TRUE(table.at(kLeft, kUp));
    EXPECT_TRUE(table.at(kRight, kUp));
    for (std::uint64_t round = 0; round < 4; ++round)
        learn(table, round, 4000);
    learn(table, 4, 100'000);
    table.choose({.photon_paths = 100, .price = 0}, 0.5);
    EXPECT_TRUE(table.at(kLeft, kUp));
    EXPECT_FALSE(table.at(kRight, kUp));
    // Twenty times as many photons have a twentieth of the variance.
    table.choose({.photon_paths = 2000, .price = 0}, 0.5);
    EXPECT_TRUE(table.at(kRight, kUp));
    // Where gathering costs more than it saves, bounces remain.
    table.choose({.photon_paths = 100, .price = 100}, 0.5);
    EXPECT_FALSE(table.at(kLeft, kUp));
}

TEST(GlossTable, WithoutCausticsThereIsNothingToGather) {
    GlossTable table(kScene);
    GlossSample none{.position = kLeft, .normal = kUp, .weight = 1};
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(table.add(none));
    table.update(100);
    table.choose({.photon_paths = 100, .price = 1e-3}, 0.5);
    EXPECT_FALSE(table.at(kLeft, kUp));
}

/// One photon in a thousand that is a thousand times as bright says that there may be more.
TEST(GlossTable, RareBrightPhotonsAreDistrusted) {
    const auto chooses_photons = [](bool rare) {
        GlossTable table(kScene);
        for (int i = 0; i < 200; ++i) {
            GlossSample s{.position = kLeft, .normal = kUp, .weight = 1, .light = 1};
            s.photons = !rare ? 1 : i == 0 ? 200 : 0;
            s.bounce = 2;
            table.add(s);
        }
        table.update(200);
        table.choose({.photon_paths = 1, .price = 0}, 0.5);
        return table.at(kLeft, kUp);
    };
    EXPECT_TRUE(chooses_photons(false));
    EXPECT_FALSE(chooses_photons(true));
}

TEST(GlossTable, UnusableSamplesAreLeftOut) {
    GlossTable table(kScene);
    const double bad[] = {-1, std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity(), 1e200};
    for (const double value : bad) {
        GlossSample s{.position = kLeft, .normal = kUp, .weight = 1, .light = 1};
        for (double* number : {&s.weight, &s.light, &s.photons}) {
            const double before = *number;
            *number = value;
            EXPECT_FALSE(table.add(s)) << value;
            *number = before;
        }
    }
}

}  // namespace
}  // namespace aips::gloss_table_test
