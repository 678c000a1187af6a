// Protects eq. 6 and the one-sample mixture: products with a Bsdf's density, exact pdfs over solid
// angle, and no bias whatever the table says.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/tables/paper_tables.h"
#include "chi_square.h"

namespace aips::product_sampling_test {
namespace {

constexpr int kResolution = 8;
const Vec3 kNormal = normalize(Vec3{0.3f, -0.5f, 0.8f});

float lambert_pdf(Vec3 w) {
    return std::max(0.0f, dot(w, kNormal)) * kInvPi;
}

/// A table with strong contrasts and the products with Lambert's density.
std::vector<float> make_products(const PaperTables& tables) {
    std::vector<float> relative(std::size_t{kResolution} * kResolution);
    for (std::size_t i = 0; i < relative.size(); ++i)
        relative[i] = i % 7 == 0 ? 5.0f : 0.1f;
    std::vector<float> products(relative.size());
    multiply_by_bsdf(relative, tables.cell_directions(), lambert_pdf, products);
    return products;
}

TEST(ProductSampling, ProductIsTableTimesBsdf) {
    const PaperTables tables({.resolution = kResolution});
    const std::vector<float> products = make_products(tables);
    for (std::size_t i = 0; i < products.size(); ++i) {
        const float relative = i % 7 == 0 ? 5.0f : 0.1f;
        EXPECT_EQ(products[i], relative * lambert_pdf(tables.cell_directions()[i]));
    }
}

TEST(ProductSampling, BadBsdfDensitiesBecomeZero) {
    const std::vector<float> relative{1, 1, 1, 1};
    const std::vector<Vec3> directions(4, Vec3{0, 0, 1});
    std::vector<float> products(4);
    multiply_by_bsdf(
        relative, directions, [](Vec3) { return std::nanf(""); }, products);
    EXPECT_TRUE(CellWeights(products, 2).empty());
}

TEST(ProductSampling, CellDirectionsAreTheCentresOfTheirCells) {
    const PaperTables tables({.resolution = kResolution});
    for (std::size_t i = 0; i < tables.cell_directions().size(); ++i) {
        EXPECT_EQ(cell_index(uniform_sphere_to_square(tables.cell_directions()[i]), kResolution),
                  i);
    }
}

// Draws against direction_pdf, on bins of the sphere that do not line up with the table's cells.
TEST(ProductSampling, DirectionsFollowTheirSolidAnglePdf) {
    constexpr int kDraws = 100000;
    constexpr int kBins = 10;
    constexpr int kSub = 40;
    const PaperTables tables({.resolution = kResolution});
    const std::vector<float> products = make_products(tables);
    const CellWeights weights(products, kResolution);
    std::vector<double> observed(std::size_t{kBins} * kBins), expected(observed.size());
    RandomStream random(21, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < kDraws; ++i) {
        const DirectionSample s = sample_direction(weights, random.next2());
        ASSERT_NEAR(length(s.direction), 1, 1e-5);
        ASSERT_GT(s.pdf, 0);
        ++observed[cell_index(uniform_sphere_to_square(s.direction), kBins)];
    }
    for (int y = 0; y < kBins * kSub; ++y) {
        for (int x = 0; x < kBins * kSub; ++x) {
            const Vec2 u{(float(x) + 0.5f) / (kBins * kSub), (float(y) + 0.5f) / (kBins * kSub)};
            const Vec3 w = square_to_uniform_sphere(u);
            expected[cell_index(u, kBins)] += double(direction_pdf(weights, w)) * 4 * kPi * kDraws /
                                              (double(kBins * kSub) * kBins * kSub);
        }
    }
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, 1e-4) << result.describe;
}

// The mean of f / p under the mixture is the integral of f: the guide changes no expectation.
TEST(ProductSampling, OneSampleMixtureIsUnbiased) {
    constexpr int kDraws = 200000;
    const PaperTables tables({.resolution = kResolution});
    const std::vector<float> products = make_products(tables);
    const CellWeights weights(products, kResolution);
    const Frame frame(kNormal);
    const auto f = [](Vec3 w) { return lambert_pdf(w) * (1 + w.x * w.x); };
    for (const float share : {0.0f, 0.1f, 0.5f, 0.9f}) {
        RandomStream random(22, 0, std::uint64_t(share * 100), RandomDomain::Guide);
        double sum = 0, squares = 0;
        for (int i = 0; i < kDraws; ++i) {
            const float choice = random.next();
            const Vec2 u = random.next2();
            const Vec3 w = choice < share ? sample_direction(weights, u).direction
                                          : frame.to_world(square_to_cosine_hemisphere(u));
            const float pdf = share * direction_pdf(weights, w) + (1 - share) * lambert_pdf(w);
            const double value = pdf > 0 ? f(w) / pdf : 0;
            sum += value;
            squares += value * value;
        }
        // integral of cos/pi (1 + x^2): the mean square of x is 1/4 + n_x^2 / 4 for Lambert.
        const double exact = 1.25 + 0.25 * double(kNormal.x * kNormal.x);
        const double mean = sum / kDraws;
        const double error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
        EXPECT_NEAR(mean, exact, 4 * error) << "share " << share;
    }
}

}  // namespace
}  // namespace aips::product_sampling_test
