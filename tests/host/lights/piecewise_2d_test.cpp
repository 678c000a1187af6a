// A piecewise-constant density states what it draws, to the step of a random number, also for cells
// beside one that has nearly all the weight.
#include "piecewise_2d.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lxs::test::piecewise_2d_test {
namespace {

TEST(Piecewise2D, DrawsWhatItStatesBesideASun) {
    constexpr std::size_t kCells = 1024;
    std::vector<float> weights(kCells, 1.0f);
    weights[300] = 1e6f;
    const Piecewise2D grid(kCells, 1, weights);
    std::vector<double> counts(kCells);
    // All numbers that there are.
    for (int i = 0; i < 1 << 24; ++i) {
        float density = 0;
        const Vec2 p = grid.sample(Vec2(static_cast<float>(i) * 0x1p-24f, 0.5f), density);
        ++counts[static_cast<std::size_t>(p.x * kCells)];
    }
    for (std::size_t c = 0; c < kCells; ++c) {
        const auto middle = (static_cast<float>(c) + 0.5f) / kCells;
        const double stated = double(grid.density(Vec2(middle, 0.5f))) / kCells * 0x1p24;
        EXPECT_NEAR(counts[c] / stated, 1, 1e-6) << c;
    }
}

}  // namespace
}  // namespace lxs::test::piecewise_2d_test
