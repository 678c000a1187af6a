// Protects the bound on fireflies that densities keep, whatever they were taught: no density falls
// below its defensive share of the plain one, so no photon weighs more than 1 / that share.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "aips/core/sampling/random.h"
#include "aips/core/tables/bounce_tables.h"
#include "aips/core/tables/discrete_distribution.h"
#include "aips/core/trees/primary_tree.h"
#include "stress_case.h"

namespace firefly_bound_test {
namespace {

using namespace aips;
using namespace stress;

constexpr double kPlain = 0.15;

/// Starts that are worth much: few points, in corners and anywhere, as rare and as rich as numbers
/// allow.
struct Adversary {
    std::vector<PrimaryPoint> points;
    std::vector<double> scores;
};

Adversary adversary(std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    Adversary made;
    const int count = 1 + int(4 * random.next());
    for (int i = 0; i < count; ++i) {
        PrimaryPoint p{};
        for (double& x : p) {
            const float kind = random.next();
            x = kind < 0.4f ? 0 : kind < 0.7f ? 1 - 0x1p-48 : double(random.next());
        }
        made.points.push_back(p);
        made.scores.push_back(std::pow(10.0, 80 * double(random.next()) - 40));
    }
    return made;
}

/// Half of the trees have no prior and forget within an update: around the points nothing is left
/// then but the plain density.
PrimaryTree taught(const Adversary& a, int updates, bool forgets) {
    PrimaryTree tree({.max_leaves = 8192,
                      .split_count = 1,
                      .split_gain = 0,
                      .memory_paths = forgets ? 1 : 4e6,
                      .prior_count = forgets ? 0.0 : 1.0});
    for (int u = 0; u < updates; ++u) {
        for (std::size_t i = 0; i < a.points.size(); ++i)
            tree.add(a.points[i], a.scores[i], u % 2 ? 1e-3 : 1e3);
        if (u % 3 == 0) {
            std::vector<PrimaryPoint> close(20, a.points[0]);
            tree.focus(close);
            tree.add_seed(a.points[0], 1e30);
        }
        tree.update(1 + u);
        tree.set_mixture({kPlain, u % 2 ? 0.05 : 0.25});
    }
    return tree;
}

/// Least density in the boxes that were split off on the way to each of the points.
double least_density(const PrimaryTree& tree, const Adversary& a) {
    double least = 1;
    RandomStream random(99, 0, 0, RandomDomain::Guide);
    const int tries = sized(20000, 200000);
    for (int i = 0; i < tries; ++i) {
        PrimaryPoint p = a.points[std::size_t(i) % a.points.size()];
        for (double& x : p) {
            const double step = std::ldexp(1 + double(random.next()), -1 - int(32 * random.next()));
            x += x < 0.5 ? step : -step;
            x = std::clamp(x, 0.0, 1 - 0x1p-48);
        }
        least = std::min(least, double(tree.pdf(p)));
        const PrimarySample s = tree.sample(p);
        least = std::min(least, double(s.pdf));
        EXPECT_NEAR(double(s.pdf) / double(tree.pdf(s.point)), 1, 1e-6);
    }
    return least;
}

TEST(StressFireflies, NoStartWeighsMoreThanThePlainShareAllows) {
    const int adversaries = sized(30, 400);
    double least = 1;
    std::uint32_t leaves = 0;
    for (int seed = 0; seed < adversaries; ++seed) {
        const Adversary a = adversary(std::uint64_t(seed));
        const PrimaryTree tree = taught(a, 120, seed % 2 > 0);
        leaves = std::max(leaves, tree.leaf_count());
        const double found = least_density(tree, a);
        ASSERT_GE(found, kPlain * (1 - 124 * 0x1p-23)) << "adversary " << seed;
        least = std::min(least, found);
    }
    std::ostringstream figure;
    figure.precision(9);
    figure << "greatest weight " << 1 / least << " of at most " << (1 + 2e-5) / kPlain << "; up to "
           << leaves << " leaves";
    record(std::to_string(adversaries) + " adversaries, scores of 1e-40 to 1e40 at 1 to 5 points",
           figure.str());
}

TEST(StressFireflies, ChoicesKeepTheirShare) {
    double least = 1;
    for (const std::size_t n : {2u, 10u, 10'000u, 1'000'000u}) {
        std::vector<float> weights(n);
        RandomStream random(5, n, 0, RandomDomain::Guide);
        double sum = 0;
        for (float& w : weights)
            sum += double(w = std::pow(10.0f, 12 * random.next() - 6));
        const DiscreteDistribution choice(weights);
        for (std::size_t i = 0; i < n; ++i) {
            const double kept = double(choice.pdf(i)) / (double(weights[i]) / sum);
            ASSERT_GE(kept, 1 - (double(n) + 1) * 0x1p-24) << n;
            least = std::min(least, kept);
        }
    }
    record("choices among up to a million weights of 1e-6 to 1e6",
           "no probability below " + std::to_string(least) + " of its own; 1 - n 2^-24 at least");
}

/// What moments may say at worst.
TEST(StressFireflies, TablesLeaveAQuarterToTheBsdf) {
    MixtureMoments all_for_the_table;
    for (int i = 0; i < 100000; ++i)
        all_for_the_table.add(1e30, 0, {1, 1e-30, 1e30});
    std::size_t share = 0;
    for (int i = 0; i < 10; ++i)
        share = choose_share(all_for_the_table, all_for_the_table, share);
    EXPECT_EQ(kTableShares[share], 0.75);
    BounceTables tables(Bounds{{0, 0, 0}, {1, 1, 1}});
    const Frame frame = Frame::world_aligned({0, 0, 1});
    float greatest = 0;
    for (int u = 0; u < 50; ++u) {
        for (int i = 0; i < 200; ++i) {
            BounceScore s;
            s.position = {float(i % 10) / 10, 0.5f, 0.5f};
            s.normal = {0, 0, 1};
            s.direction = cosine_square_direction(frame, {0.01f, 0.99f});
            s.power = 1;
            s.score = 1e30;
            s.cost = 0;
            s.drawn = s.plain = 1e-6;
            tables.add(s);
        }
        tables.update(200);
        for (int i = 0; i < 10; ++i)
            greatest = std::max(greatest, tables.at({float(i) / 10, 0.5f, 0.5f}, {0, 0, 1}).share);
    }
    EXPECT_EQ(greatest, 0.75f);
    record("tables taught one direction alone",
           "share " + std::to_string(greatest) + " of at most 0.75: weights at most 4 times");
}

}  // namespace
}  // namespace firefly_bound_test
