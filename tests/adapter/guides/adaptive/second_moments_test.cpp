// Protects the switch of guides: what it thinks that a density would be worth is what it is worth,
// whichever density the samples came from.
#include "guides/adaptive/second_moments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "aips/core/sampling/random.h"

namespace aips::second_moments_test {
namespace {

constexpr unsigned kCells = 4;
using Cells = std::array<double, kCells>;

/// A sum over four cells: what a path from each is worth and costs, and two densities to draw it.
constexpr Cells kPart{0.1, 1, 3, 0}, kCost{1, 2, 5, 3};
constexpr Cells kPlain{0.25, 0.25, 0.25, 0.25}, kGuided{0.1, 0.3, 0.5, 0.1};

/// Of guiding a path.
constexpr double kGuideCost = 0.25;
/// Second moment times mean cost of a path drawn by `p`, at `more` than the cells' own cost.
double work(const Cells& p, double more) {
    double moment = 0, cost = more;
    for (unsigned i = 0; i < kCells; ++i) {
        moment += kPart[i] * kPart[i] / p[i];
        cost += kCost[i] * p[i];
    }
    return moment * cost;
}

SecondMoments measured(const Cells& drawn, int samples, std::uint64_t seed) {
    SecondMoments moments;
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < samples; ++i) {
        double u = double(random.next());
        unsigned cell = 0;
        while (cell + 1 < kCells && u >= drawn[cell])
            u -= drawn[cell++];
        const double value = kPart[cell] / drawn[cell];
        moments.add(value * value, kCost[cell], kGuideCost, drawn[cell], kPlain[cell],
                    kGuided[cell]);
    }
    return moments;
}

/// Mean over independent runs against the closed form, at 4 standard errors (p < 1e-4).
void expect_gain_of(const Cells& drawn, std::uint64_t seed) {
    constexpr int kRuns = 100;
    double sum = 0, squares = 0;
    for (int run = 0; run < kRuns; ++run) {
        const double gain = measured(drawn, 10000, seed + std::uint64_t(run)).gain();
        sum += gain;
        squares += gain * gain;
    }
    const double mean = sum / kRuns;
    const double error = std::sqrt((squares / kRuns - mean * mean) / (kRuns - 1));
    const double expected = work(kPlain, 0) / work(kGuided, kGuideCost);
    EXPECT_LT(error, 0.01 * expected);
    EXPECT_NEAR(mean, expected, 4 * error);
}

TEST(SecondMoments, GainFromSamplesOfThePlainDensity) {
    expect_gain_of(kPlain, 1);
}

TEST(SecondMoments, GainFromSamplesOfTheGuidedDensity) {
    expect_gain_of(kGuided, 1001);
}

TEST(SecondMoments, GainFromSamplesOfAThirdDensity) {
    expect_gain_of({0.4, 0.2, 0.2, 0.2}, 2001);
}

TEST(SecondMoments, NothingIsGainedBeforeAnythingWasWorthSomething) {
    SecondMoments moments;
    EXPECT_EQ(moments.gain(), 1);
    moments.add(0, 3, 0, 1, 1, 2);
    EXPECT_EQ(moments.gain(), 1);
}

/// A sample for each group.
void add_to_all(SecondMoments& moments, double score, double cost, double guided) {
    for (std::size_t i = 0; i < SecondMoments::kGroups; ++i)
        moments.add(score, cost, 0, 1, 1, guided);
}

/// Drawn where the guided density is least, and worth more than all others together.
TEST(SecondMoments, NoSinglePathDecides) {
    SecondMoments moments = measured(kPlain, 100000, 3001);
    const double gain = moments.gain();
    for (int i = 0; i < 2; ++i)
        moments.add(1e9, 1, kGuideCost, 1, 1, 0.15);
    EXPECT_NEAR(moments.gain(), gain, 0.03 * gain);
}

TEST(SecondMoments, GainIsOfSecondMomentsTimesCosts) {
    // One path of cost c, twice as probable with the guide: moments 1 : 1/2, costs 1 : 2, gain 1.
    // A second one without worth, less probable, makes the guide's cost less:
    // (1 + c) / (0.5 (2 + c / 2)) = (1 + c) / (1 + c / 4)
    for (const double rest : {0.2, 0.5, 0.8}) {
        SecondMoments moments;
        add_to_all(moments, 1, 1, 2);
        add_to_all(moments, 0, rest, 0.5);
        EXPECT_DOUBLE_EQ(moments.gain(), (1 + rest) / (1 + rest / 4));
    }
    SecondMoments loses;
    add_to_all(loses, 1, 1, 0.5);
    add_to_all(loses, 0, 1, 1.5);
    EXPECT_LT(loses.gain(), 1);
}

TEST(SecondMoments, OldSamplesFadeAndAreOutvoted) {
    SecondMoments moments = measured(kGuided, 1000, 7);
    const double gain = moments.gain();
    moments.forget(0.01);
    EXPECT_NEAR(moments.gain(), gain, 1e-12 * gain);  // both alike
    for (int i = 0; i < 1000; ++i)
        moments.add(1, 1, 0, 1, 1, 0.5);  // gains nothing
    EXPECT_GT(gain, 1.3);
    EXPECT_NEAR(moments.gain(), 1, 0.3);
}

}  // namespace
}  // namespace aips::second_moments_test
