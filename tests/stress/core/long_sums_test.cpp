// Protects: sums that run over a whole render are true after 1e9 contributions. The core's sums are
// plain ones in double precision, whose bound for n terms of one sign is n 2^-53 of the sum; a sum
// or a count in single precision breaks it in the short form already.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "aips/core/tables/bounce_tables.h"
#include "aips/core/tables/paper_tables.h"
#include "aips/core/trees/kd_tree.h"
#include "aips/core/trees/primary_tree.h"
#include "aips/core/trees/score_cache.h"
#include "stress_case.h"
#include "tables/polya_square.h"

namespace long_sums_test {
namespace {

using namespace aips;
using namespace stress;

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};

/// Terms 0.001, 0.002 ... 1, again and again: no multiples of powers of two.
double term(std::uint64_t i) {
    return double(1 + i % 1000) * 1e-3;
}
constexpr double kMeanTerm = 0.5005, kMeanSquare = 0.3338335;

double bound(std::uint64_t terms) {
    return double(terms) * 0x1p-53;
}

void record_error(std::string_view what, std::uint64_t terms, double error, double most) {
    std::ostringstream tried, figure;
    tried << what << ", " << double(terms) << " terms";
    figure << "relative error " << error << " of at most " << most;
    record(tried.str(), figure.str());
    EXPECT_LE(error, most);
}

TEST(StressSums, PowersOfANode) {
    const std::uint64_t terms = sized<std::uint64_t>(10'000'000, 1'000'000'000);
    ValueStatistics powers;
    for (std::uint64_t i = 0; i < terms; ++i)
        powers.add(term(i));
    EXPECT_EQ(powers.count, terms);
    const double variance = kMeanSquare - kMeanTerm * kMeanTerm;
    const double error =
        std::max(std::abs(powers.mean / kMeanTerm - 1),
                 std::abs(powers.squared_deviations / double(terms) / variance - 1));
    // Each step rounds the mean and the product of two deviations.
    record_error("mean and variance of a node's powers (Welford)", terms, error, 4 * bound(terms));
}

/// Direction A has seen errors of 1, then of 3, direction B of 2: alike on average. A float's count
/// of photons stops at 2^24.
TEST(StressSums, ErrorsThatThePapersTablesSee) {
    constexpr std::uint64_t kChunk = 1 << 15;
    const std::uint64_t chunks = 2 * sized<std::uint64_t>(320, 500'000'000 / kChunk);
    struct NodeError final : ErrorCriterion {
        double value = 0;
        double error(const NodeView&) const override { return value; }
    } criterion;
    NodeTree tree(kUnit, {.max_nodes = 1});
    PaperTables tables({.present_errors = false});  // else nothing is summed
    Photon photon;
    photon.depth = 2;
    photon.direction = {0, 0, -1};
    const std::vector<Photon> along_a(kChunk, photon);
    photon.direction = {0, 0, 1};
    const std::vector<Photon> along_b(1, photon);
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
        criterion.value = 2 * chunk < chunks ? 1 : 3;
        tree.update_errors(criterion, false);
        tables.update(tree, along_a);
    }
    criterion.value = 2;
    tree.update_errors(criterion, false);
    tables.update(tree, along_b);
    const auto at = [&](Vec3 direction) {
        return double(tables.relative_error(0)[cell_index(uniform_sphere_to_square(direction), 8)]);
    };
    const double error = std::abs(at({0, 0, 1}) / at({0, 0, -1}) - 1);
    record_error("errors seen in one direction", chunks * kChunk, error,
                 bound(chunks * kChunk) + 0x1p-23);
}

TEST(StressSums, ScoresAndCostsOfTheCache) {
    const std::uint64_t terms = sized<std::uint64_t>(10'000'000, 1'000'000'000);
    ScoreCache cache(kUnit, {.memory_paths = 1e300});
    for (std::uint64_t i = 0; i < terms; ++i)
        cache.add({{0.5f, 0.5f, 0}, kUp, term(i), 2 * term(i)});
    cache.update(double(terms));
    const ScoreCache::Expectation known = cache.at({0.5f, 0.5f, 0}, kUp);
    const double error = std::max(std::abs(double(known.score) / kMeanTerm - 1),
                                  std::abs(double(known.cost) / (2 * kMeanTerm) - 1));
    // Expectations are kept in single precision.
    record_error("scores and costs of the roulette's cache", terms, error,
                 2 * bound(terms) + 0x1p-23);
}

/// Leaves that were split go on from the sums of their halves, a leaf that can't be from its own.
TEST(StressSums, PartsOfALightsPrimaryTree) {
    const std::uint64_t terms = sized<std::uint64_t>(10'000'000, 1'000'000'000);
    double error = 0;
    for (const std::uint32_t leaves : {1u, 8192u}) {
        PrimaryTree tree({.max_leaves = leaves, .memory_paths = 1e300, .sharpness = 1});
        for (std::uint64_t i = 0; i < terms; ++i)
            tree.add({0.3f, 0.3f, 0.3f, 0.3f}, term(i) * term(i), 4);
        tree.update(double(terms));
        // Mass: mean part in the image over the root of the mean cost, here 2, in each photon's
        // leaf.
        error = std::max(error, std::abs(tree.mass() / (kMeanTerm / 2) - 1));
    }
    record_error("parts of a light in the image", terms, error, 4 * bound(terms));
}

TEST(StressSums, SecondMomentsOfMixtures) {
    const std::uint64_t terms = sized<std::uint64_t>(10'000'000, 1'000'000'000);
    MixtureMoments moments;
    for (std::uint64_t i = 0; i < terms; ++i)
        moments.add(term(i), 2, {1, 1, 1});
    EXPECT_EQ(moments.count(), double(terms));
    const double mean = moments.moment(0) / double(terms);
    const double kish = kMeanTerm * kMeanTerm / kMeanSquare * double(terms);
    const double error =
        std::max(std::abs(mean / kMeanTerm - 1), std::abs(moments.effective_count() / kish - 1));
    record_error("second moments of mixtures", terms, error, 4 * bound(terms));
}

/// Two directions, one with a hundred times the other's sum.
TEST(StressSums, ScoresOfATableOfDirections) {
    const std::uint64_t terms = sized<std::uint64_t>(4'000'000, 1'000'000'000);
    BounceTableSettings settings;
    settings.places.memory_paths = 1e300;
    settings.moment_paths = 1e300;
    BounceTables tables(kUnit, settings);
    const Frame frame = Frame::world_aligned(kUp);
    const Vec2 many{0.3f, 0.3f}, few{0.8f, 0.8f};
    std::array<double, 64> sums{};
    BounceScore s;
    s.position = {0.5f, 0.5f, 0.5f};
    s.normal = kUp;
    s.power = s.drawn = s.plain = 1;
    s.score = 0.3 * 0.3;  // equal terms: those drift, where others' errors cancel
    for (std::uint64_t i = 0; i < terms; ++i) {
        s.direction = cosine_square_direction(frame, i % 100 == 99 ? few : many);
        ASSERT_TRUE(tables.add(s));
        if (i == 1000) tables.update(1000);
    }
    tables.update(double(terms));
    const double sum = 0.3 * double(terms), squares = s.score * double(terms);
    sums[cell_index(few, 8)] = 0.01 * sum;
    sums[cell_index(many, 8)] = 0.99 * sum;
    std::array<float, 64> expected{};
    polya_density<8>(std::span<const double, 64>(sums), settings.prior_count * squares / sum,
                     std::span<float, 64>(expected));
    const BounceTable in_use = tables.at(s.position, kUp);
    ASSERT_TRUE(in_use.table);
    double error = 0;
    for (const Vec2 place : {many, few}) {
        error = std::max(error, std::abs(double(in_use.table->pdf(place)) /
                                             double(expected[cell_index(place, 8)]) -
                                         1));
    }
    // The table's probabilities are multiples of 2^-24, one of a hundred cells' among them.
    record_error("scores of a table of directions", terms, error, 4 * bound(terms) + 2e-5);
}

}  // namespace
}  // namespace long_sums_test
