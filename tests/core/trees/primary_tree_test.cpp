// Protects the emission guide's density: exact, normalised, bounded below, and worth its while.
#include "aips/core/trees/primary_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "aips/core/sampling/random.h"
#include "chi_square.h"

namespace aips::primary_tree_test {
namespace {

constexpr PrimaryMixture kGuided{.plain = 0.1, .seeds = 0};

using Integrand = std::function<double(const PrimaryPoint&)>;

PrimaryPoint random_point(RandomStream& random) {
    return {random.next(), random.next(), random.next(), random.next()};
}

/// 1 in a box that fills 1/625 of the space, and faint elsewhere; its integral is kBoxIntegral.
double box(const PrimaryPoint& u) {
    bool inside = true;
    for (const double x : u)
        inside = inside && x >= 0.6 && x < 0.8;
    return inside ? 1 : 1e-3;
}
constexpr double kBoxVolume = 0.2 * 0.2 * 0.2 * 0.2;
constexpr double kBoxIntegral = kBoxVolume + 1e-3 * (1 - kBoxVolume);

PrimaryTree sharp_tree() {
    PrimaryTreeSettings settings;
    settings.sharpness = 1;
    settings.prior_count = 0;
    return PrimaryTree(settings);
}

/// Sums of f / p over draws, and of its square.
struct Estimate {
    double mean = 0, second_moment = 0;
    double standard_error(int draws) const {
        return std::sqrt((second_moment - mean * mean) / draws);
    }
};

Estimate integrate(const PrimaryTree& tree, const Integrand& f, int draws, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    Estimate e;
    for (int i = 0; i < draws; ++i) {
        const PrimarySample s = tree.sample(random_point(random));
        const double value = f(s.point) / double(s.pdf);
        e.mean += value / draws;
        e.second_moment += value * value / draws;
    }
    return e;
}

/// Blocks of photons shot by the tree's own density, each worth (f / p)^2.
void learn(PrimaryTree& tree, const Integrand& f, int blocks, int paths, std::uint64_t seed) {
    for (int b = 0; b < blocks; ++b) {
        RandomStream random(seed, std::uint64_t(b), 0, RandomDomain::Guide);
        for (int i = 0; i < paths; ++i) {
            const PrimarySample s = tree.sample(random_point(random));
            const double contribution = f(s.point) / double(s.pdf);
            tree.add(s.point, contribution * contribution);
        }
        tree.update(paths);
        tree.set_mixture(kGuided);
    }
}

TEST(PrimaryTree, UntrainedIsTheIdentity) {
    const PrimaryTree tree;
    const PrimaryPoint u{0.125, 0.5, 0.75, 1 - 0x1p-48};
    EXPECT_EQ(tree.sample(u).point, u);
    EXPECT_EQ(tree.sample(u).pdf, 1.0f);
    EXPECT_EQ(tree.mass(), 0.0);
}

TEST(PrimaryTree, DrawsFollowThePdf) {
    PrimaryTree tree;
    learn(tree, box, 12, 20000, 1);
    ASSERT_GT(tree.leaf_count(), 50u);
    constexpr int kDraws = 200000;
    constexpr std::size_t kBins = 10;
    for (unsigned axis = 0; axis < 4; ++axis) {
        std::vector<double> observed(kBins * kBins), expected(kBins * kBins);
        RandomStream random(2, axis, 0, RandomDomain::Guide);
        const unsigned other = (axis + 1) % 4;
        const auto bin = [&](const PrimaryPoint& p) {
            return std::size_t(p[axis] * float(kBins)) * kBins +
                   std::size_t(p[other] * float(kBins));
        };
        for (int i = 0; i < kDraws; ++i) {
            const PrimarySample s = tree.sample(random_point(random));
            for (const double x : s.point)
                ASSERT_TRUE(x >= 0 && x < 1);
            ASSERT_FLOAT_EQ(s.pdf, tree.pdf(s.point));
            ++observed[bin(s.point)];
        }
        // The pdf's marginal, by many plain points: a second, independent sample's noise is added.
        constexpr int kPlain = 4000000;
        std::vector<double> squares(expected.size());
        for (int i = 0; i < kPlain; ++i) {
            const PrimaryPoint p = random_point(random);
            const double value = double(tree.pdf(p)) * kDraws / kPlain;
            expected[bin(p)] += value;
            squares[bin(p)] += value * value;
        }
        double statistic = 0;
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const double difference = observed[k] - expected[k];
            statistic += difference * difference / (expected[k] + squares[k]);
        }
        // 99 degrees of freedom: beyond 160 with probability 1e-4.
        EXPECT_LT(statistic, 160) << "axis " << axis;
    }
}

TEST(PrimaryTree, DensityIntegratesToOneAndIsBoundedBelow) {
    PrimaryTree tree;
    learn(tree, box, 10, 20000, 3);
    RandomStream random(4, 0, 0, RandomDomain::Guide);
    double inverse = 0;
    constexpr int kDraws = 100000;
    for (int i = 0; i < kDraws; ++i) {
        const PrimarySample s = tree.sample(random_point(random));
        ASSERT_GE(s.pdf, float(kGuided.plain) * (1 - 1e-6f));
        inverse += 1 / double(s.pdf) / kDraws;
    }
    // E[1 / p] over draws from p is the volume of the domain; each term is in (0, 10].
    EXPECT_NEAR(inverse, 1, 4 * std::sqrt(10.0 / kDraws));
}

TEST(PrimaryTree, EstimatesStayUnbiasedAndBecomeFarBetter) {
    PrimaryTree tree = sharp_tree();
    const PrimaryTree plain;
    learn(tree, box, 12, 20000, 5);
    constexpr int kDraws = 100000;
    const Estimate guided = integrate(tree, box, kDraws, 6);
    EXPECT_NEAR(guided.mean, kBoxIntegral, 4 * guided.standard_error(kDraws));
    const Estimate unguided = integrate(plain, box, kDraws, 7);
    const auto variance = [](const Estimate& e) { return e.second_moment - e.mean * e.mean; };
    EXPECT_GT(variance(unguided) / variance(guided), 30);
}

TEST(PrimaryTree, MassMeasuresTheLightsPartInTheImage) {
    PrimaryTree tree = sharp_tree();
    learn(tree, box, 12, 20000, 8);
    EXPECT_NEAR(tree.mass(), kBoxIntegral, 0.05 * kBoxIntegral);
}

// Variance times cost is least where the density goes with 1 / sqrt(cost).
TEST(PrimaryTree, CostlyPhotonsAreShotLess) {
    PrimaryTree tree = sharp_tree();
    for (int block = 0; block < 10; ++block) {
        RandomStream random(9, std::uint64_t(block), 0, RandomDomain::Guide);
        for (int i = 0; i < 5000; ++i) {
            const PrimarySample s = tree.sample(random_point(random));
            const double contribution = (s.point[2] < 0.25f ? 1.0 : 0.5) / double(s.pdf);
            tree.add(s.point, contribution * contribution, s.point[2] < 0.5f ? 9 : 1);
        }
        tree.update(5000);
        tree.set_mixture({.plain = 0.01, .seeds = 0});
    }
    const float cheap = tree.pdf({0.5f, 0.5f, 0.9f, 0.5f});
    EXPECT_NEAR(tree.pdf({0.5f, 0.5f, 0.1f, 0.5f}) / cheap, 2.0 / 3, 0.1);
    EXPECT_NEAR(tree.pdf({0.5f, 0.5f, 0.4f, 0.5f}) / cheap, 1.0 / 3, 0.1);
}

TEST(PrimaryTree, KeepsStratification) {
    PrimaryTree tree;
    learn(tree, box, 8, 20000, 10);
    // Along one coordinate the warp is monotone within what the others choose.
    double last = -1;
    for (int i = 0; i < 1000; ++i) {
        const double x = tree.sample({float(i) / 1000, 0.999f, 0.999f, 0.999f}).point[0];
        ASSERT_GE(x, last);
        last = x;
    }
}

TEST(PrimaryTree, SeedsShapeTheDensityBeforeAnythingIsLearned) {
    PrimaryTree tree;
    RandomStream random(11, 0, 0, RandomDomain::Guide);
    for (int round = 0; round < 10; ++round) {
        for (int i = 0; i < 500; ++i) {
            PrimaryPoint p = random_point(random);
            for (double& x : p)
                x = 0.7 + 0.05 * x;
            tree.add_seed(p, 1);
        }
        tree.update(0);
    }
    tree.set_mixture({.plain = 0.2, .seeds = 0.5});
    EXPECT_GT(tree.pdf({0.72f, 0.72f, 0.72f, 0.72f}), 50.0f);
    EXPECT_NEAR(tree.pdf({0.1f, 0.1f, 0.1f, 0.1f}), 0.5f, 1e-3f);  // what nothing learned leaves
    EXPECT_EQ(tree.mass(), 0.0);
}

/// Seeds in a cube about `middle`, its sides 2^-20 along two axes and 1 along the others, and as a
/// twentieth of them seeds anywhere.
std::vector<PrimaryPoint> narrow_seeds(float middle, std::size_t count) {
    RandomStream random(14, 0, 0, RandomDomain::Guide);
    std::vector<PrimaryPoint> seeds;
    for (std::size_t i = 0; i < count; ++i) {
        PrimaryPoint p = random_point(random);
        if (i % 20 > 0) {
            for (const unsigned axis : {0u, 1u})
                p[axis] = middle + 0x1p-20 * (p[axis] - 0.5);
        }
        seeds.push_back(p);
    }
    return seeds;
}

/// A picture on a ground a thousand times as wide as what is seen: light starts in a millionth of
/// all points, about the middle, where halving gains nothing, or beside it.
TEST(PrimaryTree, FocusesOnNarrowSeedsAtOnce) {
    for (const float middle : {0.5f, 0.3f}) {
        PrimaryTree tree;
        std::vector<PrimaryPoint> seeds = narrow_seeds(middle, 100);
        tree.focus(seeds);
        for (const PrimaryPoint& p : seeds)
            tree.add_seed(p, 1);
        tree.update(0);
        tree.set_mixture({.plain = 0.2, .seeds = 0.5});
        EXPECT_LT(tree.leaf_count(), 200u);
        RandomStream random(15, 0, 0, RandomDomain::Guide);
        int near = 0;
        constexpr int kDraws = 1000;
        for (int i = 0; i < kDraws; ++i) {
            const PrimaryPoint p = tree.sample(random_point(random)).point;
            near += std::abs(p[0] - middle) < 0x1p-17f && std::abs(p[1] - middle) < 0x1p-17f;
        }
        // All of the seeds' share, but for the twentieth that lies apart.
        EXPECT_GT(near, 0.4 * kDraws) << middle;
    }
}

/// A view of 14 mm on a ground of 20 km: leaves become as narrow as what is seen, and starts within
/// them lie everywhere, not on the lattice of a coarser number.
TEST(PrimaryTree, StartsFillTheNarrowestLeaves) {
    constexpr double kMiddle = 0.3, kWidth = 0x1p-27;
    PrimaryTree tree;
    RandomStream random(17, 0, 0, RandomDomain::Guide);
    std::vector<PrimaryPoint> seeds;
    for (int i = 0; i < 100; ++i) {
        PrimaryPoint p = random_point(random);
        for (const unsigned axis : {0u, 1u})
            p[axis] = kMiddle + kWidth * p[axis];
        seeds.push_back(p);
    }
    tree.focus(seeds);
    for (const PrimaryPoint& p : seeds)
        tree.add_seed(p, 1);
    tree.update(0);
    tree.set_mixture({.plain = 0.2, .seeds = 0.5});
    constexpr std::size_t kCells = 32;
    std::vector<double> observed(kCells), expected(kCells);
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        const PrimaryPoint u = primary_point(
            {random.next_uint(), random.next_uint(), random.next_uint(), random.next_uint()});
        const PrimarySample s = tree.sample(u);
        ASSERT_EQ(s.pdf, tree.pdf(s.point));
        const double x = (s.point[0] - kMiddle) / kWidth, y = (s.point[1] - kMiddle) / kWidth;
        if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) continue;
        // Each draw stands for 1 / pdf of the box, which its cells share alike.
        observed[std::size_t(x * double(kCells))] += 1 / double(s.pdf);
        expected[std::size_t(x * double(kCells))] += 1 / (double(s.pdf) * double(s.pdf));
    }
    const double volume = kWidth * kWidth / double(kCells);
    for (std::size_t cell = 0; cell < kCells; ++cell) {
        const double error = std::sqrt(expected[cell]) / kDraws;
        ASSERT_GT(error, 0) << "no start in cell " << cell;
        EXPECT_LT(error, 0.1 * volume) << "few starts come there";
        // 32 cells: 4.2 standard errors are passed by chance once in a thousand times.
        EXPECT_NEAR(observed[cell] / kDraws, volume, 4.2 * error) << cell;
    }
}

TEST(PrimaryTree, FocusKeepsHalfOfItsLeavesAndWideSeedsAlone) {
    PrimaryTree wide;
    RandomStream random(16, 0, 0, RandomDomain::Guide);
    std::vector<PrimaryPoint> seeds(200);
    for (PrimaryPoint& p : seeds)
        p = random_point(random);
    wide.focus(seeds);
    EXPECT_EQ(wide.leaf_count(), 1u);

    PrimaryTree small({.max_leaves = 16});
    std::vector<PrimaryPoint> narrow = narrow_seeds(0.3f, 40);
    small.focus(narrow);
    EXPECT_EQ(small.leaf_count(), 8u);
}

TEST(PrimaryTree, ForgetsWhatIsOutdated) {
    PrimaryTreeSettings settings;
    settings.memory_paths = 40000;
    PrimaryTree tree(settings);
    const Integrand left = [](const PrimaryPoint& u) { return u[0] < 0.5f ? 1.0 : 0.0; };
    const Integrand right = [](const PrimaryPoint& u) { return u[0] >= 0.5f ? 1.0 : 0.0; };
    learn(tree, left, 5, 20000, 12);
    EXPECT_GT(tree.pdf({0.2f, 0.5f, 0.5f, 0.5f}), tree.pdf({0.8f, 0.5f, 0.5f, 0.5f}));
    learn(tree, right, 10, 20000, 13);
    EXPECT_LT(tree.pdf({0.2f, 0.5f, 0.5f, 0.5f}), tree.pdf({0.8f, 0.5f, 0.5f, 0.5f}));
}

// Paths from one start are worth very different amounts: all else but the start is drawn, too. The
// leaves' means are then noisy, and a density that follows them in full is led astray where luck
// was bad; the flatter one is better on samples that neither has seen.
TEST(PrimaryTree, UnderHeavyTailsTheFlatterDensityIsBetter) {
    const Integrand f = [](const PrimaryPoint& u) { return 0.2 + double(u[0]) * double(u[1]); };
    constexpr double kTail = 1.1, kLargest = 1000;  // of |f|, Pareto, cut: its square has a mean
    constexpr double kRare = 0.02;                  // paths that are seen at all
    const auto second_moment = [&](double sharpness, std::uint64_t seed) {
        PrimaryTreeSettings settings;
        settings.sharpness = sharpness;
        settings.prior_count = 0;
        PrimaryTree tree(settings);
        for (int block = 0; block < 10; ++block) {
            RandomStream random(seed, std::uint64_t(block), 0, RandomDomain::Guide);
            for (int i = 0; i < 20000; ++i) {
                const PrimarySample s = tree.sample(random_point(random));
                const bool seen = random.next() < float(kRare);
                const double tail =
                    std::min(kLargest, std::pow(1 - double(random.next()), -1 / kTail));
                const double contribution = seen ? tail * f(s.point) / double(s.pdf) : 0;
                tree.add(s.point, contribution * contribution);
            }
            tree.update(20000);
            tree.set_mixture(kGuided);
        }
        // Of fresh samples; the tail's own second moment is a factor that all densities share.
        return integrate(tree, f, 50000, seed + 100).second_moment;
    };
    double sharp = 0, flat = 0;
    for (std::uint64_t seed = 20; seed < 25; ++seed) {
        sharp += second_moment(1, seed);
        flat += second_moment(0.5, seed);
    }
    EXPECT_LT(flat, 0.9 * sharp);
    EXPECT_LT(PrimaryTreeSettings{}.sharpness, 1);
}

// One path in a hundred is worth something, wherever it starts: leaves that were unlucky must not
// be taken for empty, nor lucky ones for bright.
TEST(PrimaryTree, FewScoresProveLittle) {
    const Integrand flat = [](const PrimaryPoint&) { return 1.0; };
    const auto second_moment = [&](double prior_count) {
        PrimaryTreeSettings settings;
        settings.sharpness = 1;
        settings.split_gain = 0;
        settings.prior_count = prior_count;
        PrimaryTree tree(settings);
        for (int block = 0; block < 5; ++block) {
            RandomStream random(30, std::uint64_t(block), 0, RandomDomain::Guide);
            for (int i = 0; i < 10000; ++i) {
                const PrimarySample s = tree.sample(random_point(random));
                const double contribution = random.next() < 0.01f ? 1 / double(s.pdf) : 0;
                tree.add(s.point, contribution * contribution);
            }
            tree.update(10000);
            tree.set_mixture(kGuided);
        }
        EXPECT_GE(tree.leaf_count(), 8u);
        return integrate(tree, flat, 50000, 31).second_moment;
    };
    // 1 is what the uniform density gives.
    EXPECT_LT(second_moment(4) - 1, 0.7 * (second_moment(0) - 1));
}

TEST(PrimaryTree, RefusesBadScoresAndSettings) {
    PrimaryTree tree;
    const PrimaryPoint p{0.5f, 0.5f, 0.5f, 0.5f};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, -1.0, 0.0, std::numeric_limits<double>::infinity()}) {
        tree.add(p, bad);
        tree.add_seed(p, bad);
    }
    tree.add(p, 1, nan);
    tree.add(p, 1, 0);
    tree.update(100);
    tree.set_mixture(kGuided);
    EXPECT_EQ(tree.mass(), 0.0);
    EXPECT_EQ(tree.pdf(p), 1.0f);
    EXPECT_THROW(PrimaryTree({.max_leaves = 0}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.split_count = 0}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.split_gain = nan}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.memory_paths = 0}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.sharpness = 0}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.sharpness = 1.5}), std::invalid_argument);
    EXPECT_THROW(PrimaryTree({.prior_count = -1}), std::invalid_argument);
}

// A delta at one point: sides stop shrinking, leaves stop multiplying, memory stays.
TEST(PrimaryTree, AllPhotonsAtOnePoint) {
    PrimaryTreeSettings settings;
    settings.max_leaves = 64;
    settings.split_count = 1;
    settings.split_gain = 0;
    PrimaryTree tree(settings);
    const std::size_t bytes = tree.memory_bytes();
    for (int round = 0; round < 200; ++round) {
        tree.add({0.3f, 0.3f, 0.3f, 0.3f}, 1);
        tree.update(1);
        tree.set_mixture(kGuided);
    }
    EXPECT_LE(tree.leaf_count(), 64u);
    EXPECT_EQ(tree.memory_bytes(), bytes);
    EXPECT_LE(bytes, PrimaryTree::memory_bound_bytes(settings));
    const PrimarySample s = tree.sample({0.5f, 0.5f, 0.5f, 0.5f});
    EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf > 0);
}

}  // namespace
}  // namespace aips::primary_tree_test
