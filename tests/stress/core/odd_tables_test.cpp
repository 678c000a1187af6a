// Protects: tables of directions and choices draw what their density says, and that integrates to
// one, whatever the weights: a single cell, none, all alike, denormal, 1e38, NaN among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>

#include "aips/core/sampling/random.h"
#include "aips/core/tables/directional_table.h"
#include "aips/core/tables/discrete_distribution.h"
#include "stress_case.h"
#include "tables/polya_square.h"

namespace odd_tables_test {
namespace {

using namespace aips;
using namespace stress;

constexpr float kMost = std::numeric_limits<float>::max();
constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

struct Weights {
    std::string name;
    std::function<float(std::size_t cell, std::size_t count)> of;
};

std::vector<Weights> odd_weights() {
    return {{"all zero", [](auto, auto) { return 0.0f; }},
            {"all alike", [](auto, auto) { return 0.3f; }},
            {"all 3e38", [](auto, auto) { return kMost; }},
            {"all denormal", [](auto, auto) { return kDenormal; }},
            {"first cell only", [](auto i, auto) { return i == 0 ? 1.0f : 0.0f; }},
            {"last cell only", [](auto i, auto n) { return i + 1 == n ? 1.0f : 0.0f; }},
            {"middle cell only, denormal",
             [](auto i, auto n) { return i == n / 2 ? kDenormal : 0.0f; }},
            {"3e38 beside denormals", [](auto i, auto) { return i == 1 ? kMost : kDenormal; }},
            {"2^-i", [](auto i, auto) { return std::ldexp(1.0f, -int(i % 120)); }},
            {"NaN, negative, infinite", [](auto i, auto) {
                 const float odd[] = {std::nanf(""), -1.0f, 1.0f, -kMost};
                 return i == 5 ? std::numeric_limits<float>::infinity() : odd[i % 4];
             }}};
}

std::vector<float> made(const Weights& weights, std::size_t count) {
    std::vector<float> made(count);
    for (std::size_t i = 0; i < count; ++i)
        made[i] = weights.of(i, count);
    return made;
}

/// At the centre of each cell.
template <class Table>
double integral(const Table& table, int n) {
    double sum = 0;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x)
            sum += double(table.pdf({(float(x) + 0.5f) / float(n), (float(y) + 0.5f) / float(n)}));
    }
    return sum / (double(n) * n);
}

/// Draws from random numbers and from the ends of the unit interval: each has the density that
/// pdf() gives, and lies in a cell that has any.
template <class Table>
void expect_draws_as_pdf(const Table& table) {
    constexpr float kEnds[] = {0, 0x1p-24f, 0.5f, 0x1.fffffep-1f};
    RandomStream random(3, 0, 0, RandomDomain::Guide);
    const int draws = sized(500, 20000);
    for (int i = 0; i < draws; ++i) {
        const Vec2 u = i < 16 ? Vec2{kEnds[i % 4], kEnds[i / 4]} : random.next2();
        const SquareSample s = table.sample(u);
        ASSERT_TRUE(s.point.x >= 0 && s.point.x < 1 && s.point.y >= 0 && s.point.y < 1);
        ASSERT_TRUE(s.pdf > 0 && std::isfinite(s.pdf));
        ASSERT_NEAR(double(s.pdf) / double(table.pdf(s.point)), 1, 1e-5);
    }
}

TEST(StressTables, DrawAndWeighOddWeights) {
    double worst = 0;
    for (const Weights& weights : odd_weights()) {
        for (const int n : {1, 2, 3, 8, 64}) {
            SCOPED_TRACE(weights.name + ", " + std::to_string(n));
            const std::vector<float> cells = made(weights, std::size_t(n) * std::size_t(n));
            DirectionalTable table(n);
            table.build(cells);
            ASSERT_NEAR(integral(table, n), 1, 1e-5);
            worst = std::max(worst, std::abs(integral(table, n) - 1));
            expect_draws_as_pdf(table);
            std::vector<float> clean;
            std::transform(cells.begin(), cells.end(), std::back_inserter(clean), sanitized_weight);
            const CellWeights product(clean, n);
            const bool none =
                std::all_of(clean.begin(), clean.end(), [](float w) { return w == 0; });
            ASSERT_EQ(product.empty(), none);
            if (none) continue;
            ASSERT_NEAR(integral(product, n), 1, 1e-5);
            expect_draws_as_pdf(product);
        }
    }
    record("10 sets of odd weights in tables of 1 to 64 cells a side, built and as products",
           "integral off by " + std::to_string(worst) + " of at most 1e-5; draws as the density");
}

TEST(StressTables, ChooseAmongOddWeights) {
    for (const Weights& weights : odd_weights()) {
        for (const std::size_t n : {1u, 2u, 7u, 10000u}) {
            SCOPED_TRACE(weights.name + ", " + std::to_string(n));
            const DiscreteDistribution choice(made(weights, n));
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i)
                sum += double(choice.pdf(i));
            ASSERT_EQ(sum, choice.empty() ? 0 : 1);
            for (int i = 0; i < 1000 && !choice.empty(); ++i) {
                const float u = i ? std::min(float(i) / 999, 0x1.fffffep-1f) : 0.0f;
                const DiscreteSample s = choice.sample(u);
                ASSERT_GT(s.pdf, 0);
                ASSERT_EQ(s.pdf, choice.pdf(s.index));
                ASSERT_TRUE(s.u >= 0 && s.u < 1);
            }
        }
    }
    record("10 sets of odd weights, 1 to 10,000 alternatives", "probabilities sum to 1 exactly");
}

TEST(StressTables, DensitiesOfOddSumsHaveMeanOne) {
    for (const double scale : {1e-300, 1e-30, 1.0, 1e30, 1e290}) {
        for (const int cell : {-1, 0, 63}) {
            std::array<double, 64> sums{};
            if (cell < 0) sums.fill(scale);
            if (cell >= 0) sums[std::size_t(cell)] = scale;
            std::array<float, 64> density{};
            polya_density<8>(std::span<const double, 64>(sums), 8 * scale,
                             std::span<float, 64>(density));
            ASSERT_NEAR(std::accumulate(density.begin(), density.end(), 0.0) / 64, 1, 1e-5);
            ASSERT_GT(*std::min_element(density.begin(), density.end()), 0);
        }
    }
    record("sums of 1e-300 to 1e290 in one cell and in all", "mean density 1, none 0");
}

}  // namespace
}  // namespace odd_tables_test
