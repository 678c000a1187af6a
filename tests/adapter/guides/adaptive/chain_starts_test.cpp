// Protects where the independent paths of chains start: what is drawn is told in the coordinates of
// plain paths, with the weight that makes plain starts of it, whatever was learned; and what is
// learned changes later passes alone.
#include "guides/adaptive/chain_starts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eye/light_choice.h"
#include "mock_scene.h"

namespace aips::chain_starts_test {
namespace {

/// Lamps of powers 1, 6 and 2.
struct Lamps {
    mock::Scene scene;
    DiscreteDistribution choice;
    Settings settings;

    Lamps() {
        mock::Surface wall;
        scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
        for (const float power : {1.0f, 6.0f, 2.0f})
            scene.add_point_light({0, 0, 0.1f * power}, {power, power, power});
        scene.finish();
        choice = light_choice(scene);
    }
};

/// Visible paths start from lamp 2, in 1/64 of its starts.
bool visible(const EmissionStart& start) {
    return start.light == 2 && start.point[0] < 0.125 && start.point[3] >= 0.875;
}

/// Passes of which each draws by what those before found.
void learn(ChainStarts& starts, int passes) {
    std::vector<Coordinate> coordinates;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::uint64_t i = 0; i < 5000; ++i) {
            RandomStream random(1, std::uint64_t(pass), i, RandomDomain::UniformPath);
            const EmissionStart start = starts.draw(random, coordinates);
            starts.add(start, visible(start), 2);
            if (visible(start)) starts.add_visible(starts.at(coordinates), 1e-5, 2);
        }
        starts.end_pass();
    }
}

TEST(ChainStarts, CoordinatesMeanWhatWasDrawn) {
    const Lamps lamps;
    ChainStarts starts(lamps.scene, lamps.settings, lamps.choice);
    learn(starts, 6);
    ASSERT_TRUE(starts.on());
    std::vector<Coordinate> coordinates;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        RandomStream random(2, 0, i, RandomDomain::UniformPath);
        const EmissionStart drawn = starts.draw(random, coordinates);
        ASSERT_EQ(coordinates.size(), kEmissionCoordinates);
        const EmissionStart meant = starts.at(coordinates);
        ASSERT_EQ(meant.light, drawn.light);
        for (unsigned axis = 0; axis < kStartCoordinates; ++axis)
            ASSERT_NEAR(meant.point[axis], drawn.point[axis], 0x1p-32);
    }
}

/// Weighted, draws are plain ones: the mean of the weight over each cell of coordinates is the
/// cell's size. 3 lamps by 16 cells by 2 halves of what chooses a lamp, z-tests at a family-wise
/// significance of 1e-3.
TEST(ChainStarts, WeightsMakePlainStartsOfThem) {
    const Lamps lamps;
    for (const int passes : {0, 6}) {
        SCOPED_TRACE(passes);
        ChainStarts starts(lamps.scene, lamps.settings, lamps.choice);
        learn(starts, passes);
        constexpr std::size_t kCells = std::size_t{3} * 16 * 2;
        constexpr std::uint64_t kDraws = 400'000;
        std::vector<double> sums(kCells), squares(kCells);
        std::vector<Coordinate> coordinates;
        double visible_draws = 0;
        for (std::uint64_t i = 0; i < kDraws; ++i) {
            RandomStream random(3, 0, i, RandomDomain::UniformPath);
            const EmissionStart start = starts.draw(random, coordinates);
            const double weight = starts.weight(start);
            ASSERT_LT(weight, 1.001 / kPlainChainStarts);
            visible_draws += visible(start);
            const float u = to_unit_float(coordinates[kStartCoordinates]);
            const std::size_t half = lamps.choice.sample(u).u < 0.5f ? 0 : 1;
            const std::size_t cell =
                (start.light * std::size_t{16} + (coordinates[0] >> 30) * std::size_t{4} +
                 (coordinates[3] >> 30)) *
                    2 +
                half;
            sums[cell] += weight;
            squares[cell] += weight * weight;
        }
        for (std::size_t cell = 0; cell < kCells; ++cell) {
            const double mean = sums[cell] / kDraws;
            const double error = std::sqrt((squares[cell] / kDraws - mean * mean) / kDraws);
            const double size = double(lamps.choice.pdf(cell / 32)) / 32;
            EXPECT_NEAR(mean, size, 4.4 * error) << cell;
        }
        // Of plain starts one in 300 is visible.
        EXPECT_EQ(visible_draws > 0.4 * kDraws, passes > 0);
    }
}

/// Else a pass's draws would depend on what it found.
TEST(ChainStarts, AreTheSameUntilThePassEnds) {
    const Lamps lamps;
    ChainStarts starts(lamps.scene, lamps.settings, lamps.choice);
    learn(starts, 2);
    const auto drawn = [&] {
        std::vector<Coordinate> coordinates, all;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            RandomStream random(4, 0, i, RandomDomain::UniformPath);
            starts.draw(random, coordinates);
            all.insert(all.end(), coordinates.begin(), coordinates.end());
        }
        return all;
    };
    const auto before = drawn();
    for (int i = 0; i < 2000; ++i) {
        const EmissionStart start{1, {0.3, 0.3, 0.3, 0.3}, 0.5};
        starts.add(start, true, 1);
        starts.add_visible(start, 1e-3, 1);
    }
    EXPECT_EQ(drawn(), before);
    starts.end_pass();
    EXPECT_NE(drawn(), before);
}

}  // namespace
}  // namespace aips::chain_starts_test
