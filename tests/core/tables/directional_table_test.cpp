// Protects the directional tables: draws follow the exact pdf, for any n and any weights.
#include "aips/core/tables/directional_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"
#include "chi_square.h"

namespace aips::directional_table_test {
namespace {

using Weights = std::vector<float>;
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kSignificance = 1e-4;

Weights random_weights(int n, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    Weights weights(std::size_t(n * n));
    for (float& w : weights) {
        const float u = random.next();
        w = u < 0.2f ? 0.0f : u * u * u;
    }
    return weights;
}

template <class Table>
void expect_draws_follow_pdf(const Table& table, int n, int tests) {
    constexpr int kDraws = 50000;
    const int parts = 2 * n;  // each cell in four, to see the density within cells too
    std::vector<double> observed(std::size_t(parts * parts)), expected(observed.size());
    RandomStream random(11, 0, std::uint64_t(n), RandomDomain::Guide);
    for (int i = 0; i < kDraws; ++i) {
        const SquareSample s = table.sample(random.next2());
        ASSERT_GT(s.pdf, 0.0f);
        ASSERT_NEAR(s.pdf, table.pdf(s.point), 1e-6f * s.pdf);
        ASSERT_TRUE(s.point.x >= 0 && s.point.x < 1 && s.point.y >= 0 && s.point.y < 1);
        ++observed[cell_index(s.point, parts)];
    }
    for (int y = 0; y < parts; ++y) {
        for (int x = 0; x < parts; ++x) {
            const Vec2 center{(float(x) + 0.5f) / float(parts), (float(y) + 0.5f) / float(parts)};
            expected[std::size_t(y) * std::size_t(parts) + std::size_t(x)] =
                double(table.pdf(center)) * kDraws / (double(parts) * parts);
        }
    }
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, test::sidak(kSignificance, tests)) << result.describe;
}

template <class Table>
double integral(const Table& table, int n) {
    double sum = 0;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            sum += double(table.pdf({(float(x) + 0.5f) / float(n), (float(y) + 0.5f) / float(n)}));
        }
    }
    return sum / (double(n) * n);
}

class TableOfSize : public testing::TestWithParam<int> {};

TEST_P(TableOfSize, DrawsFollowThePdf) {
    const int n = GetParam();
    Weights weights = random_weights(n, 1);
    weights[0] = 1;
    DirectionalTable table(n);
    table.build(weights);
    expect_draws_follow_pdf(table, n, 12);
    expect_draws_follow_pdf(CellWeights(weights, n), n, 12);
}

TEST_P(TableOfSize, PdfIntegratesToOne) {
    const int n = GetParam();
    Weights weights = random_weights(n, 2);
    weights[0] = 1;
    DirectionalTable table(n);
    EXPECT_NEAR(integral(table, n), 1, 1e-6);
    table.build(weights);
    EXPECT_NEAR(integral(table, n), 1, 1e-5);
    EXPECT_NEAR(integral(CellWeights(weights, n), n), 1, 1e-5);
}

// Corners of cells are where rounding could put a point into the neighbour, whose pdf may be zero.
TEST_P(TableOfSize, PointsStayInTheirCells) {
    const int n = GetParam();
    Weights weights(std::size_t(n * n));
    for (std::size_t i = 0; i < weights.size(); i += 2)
        weights[i] = 1;
    DirectionalTable table(n);
    table.build(weights);
    const CellWeights view(weights, n);
    for (int k = 0; k <= 4 * n; ++k) {
        const float at = float(k) / float(4 * n);
        for (const float x : {std::nextafter(at, 0.0f), at, std::nextafter(at, 1.0f)}) {
            for (const float y : {at, 0.0f, kBelowOne}) {
                ASSERT_GT(table.pdf(table.sample({x, y}).point), 0.0f);
                ASSERT_GT(view.pdf(view.sample({x, y}).point), 0.0f);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TableOfSize, testing::Values(1, 2, 3, 4, 8, 49),
                         [](const auto& instance) { return "n" + std::to_string(instance.param); });

TEST(DirectionalTable, PdfIsProportionalToTheWeights) {
    DirectionalTable table(2);
    table.build(Weights{1, 2, 3, 2});
    EXPECT_NEAR(table.pdf({0.1f, 0.1f}), 0.5f, 1e-6);
    EXPECT_NEAR(table.pdf({0.9f, 0.1f}), 1.0f, 1e-6);
    EXPECT_NEAR(table.pdf({0.1f, 0.9f}), 1.5f, 1e-6);
    EXPECT_NEAR(table.pdf({0.9f, 0.9f}), 1.0f, 1e-6);
}

TEST(DirectionalTable, AllZeroIsUniform) {
    DirectionalTable table(4);
    table.build(Weights(16, 0.0f));
    EXPECT_NEAR(table.pdf({0.3f, 0.6f}), 1.0f, 1e-6);
    table.build(Weights{0, -1, kNan, 0, 0, -kInf, 0, 0, 0, 0, 0, 0, 0, 0, 0, kNan});
    EXPECT_NEAR(table.pdf({0.3f, 0.6f}), 1.0f, 1e-6);
}

// Zero bins are never drawn: unbounded weights would follow.
TEST(DirectionalTable, ZeroCellsAreNeverDrawn) {
    DirectionalTable table(3);
    table.build(Weights{0, 0, 0, 0, 5, 0, 0, 0, 0});
    for (int i = 0; i <= 100; ++i) {
        for (int j = 0; j <= 100; ++j) {
            const SquareSample s = table.sample({float(i) / 100, float(j) / 100});
            ASSERT_EQ(cell_index(s.point, 3), 4u);
            ASSERT_EQ(s.pdf, 9.0f);
        }
    }
    EXPECT_EQ(table.pdf({0, 0}), 0.0f);
}

TEST(DirectionalTable, ExtremeWeightsGiveFiniteDensities) {
    const Weights cases[] = {{1e38f, 3e38f, kInf, 1e38f},
                             {1e-45f, 0, 1e-45f, 0},
                             {1e-45f, 3e38f, 1, 1e-20f},
                             {kNan, 1, kNan, -1}};
    for (const Weights& weights : cases) {
        DirectionalTable table(2);
        table.build(weights);
        Weights clean;
        for (const float w : weights)
            clean.push_back(sanitized_weight(w));
        const CellWeights view(clean, 2);
        EXPECT_FALSE(view.empty());
        for (int i = 0; i <= 64; ++i) {
            const Vec2 u{float(i % 9) / 8, float(i) / 64};
            for (const SquareSample& s : {table.sample(u), view.sample(u)}) {
                ASSERT_TRUE(s.pdf >= 0x1p-46f && std::isfinite(1 / s.pdf)) << s.pdf;
            }
        }
        EXPECT_NEAR(integral(table, 2), 1, 1e-5);
        EXPECT_NEAR(integral(view, 2), 1, 1e-5);
    }
}

TEST(DirectionalTable, NumbersOutsideTheSquareAreHarmless) {
    const DirectionalTable table(4);
    for (const float bad : {-1.0f, 1.0f, 2.0f, kInf, -kInf, kNan}) {
        const SquareSample s = table.sample({bad, bad});
        EXPECT_TRUE(s.point.x >= 0 && s.point.x < 1 && s.pdf > 0);
        EXPECT_GT(table.pdf({bad, bad}), 0.0f);
    }
}

TEST(DirectionalTable, RefusesWrongSizes) {
    EXPECT_THROW(DirectionalTable(0), std::invalid_argument);
    EXPECT_THROW(DirectionalTable(4).build(Weights(15, 1.0f)), std::invalid_argument);
}

TEST(CellWeights, EmptyWhenAllAreZero) {
    const Weights zeros(16, 0.0f);
    const CellWeights view(zeros, 4);
    EXPECT_TRUE(view.empty());
    EXPECT_EQ(view.pdf({0.5f, 0.5f}), 0.0f);
}

}  // namespace
}  // namespace aips::directional_table_test
