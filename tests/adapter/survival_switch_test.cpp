// Protects the switch of roulette by score: what it thinks of either way is what that way is worth,
// whichever of them the paths were traced with.
#include "survival_switch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "aips/core/random.h"

namespace {

using namespace aips;

/// What either way makes of a photon of power 1 at the two vertices of a path.
using Way = std::array<float, 2>;
constexpr Way kPlain{0.9f, 0.8f}, kScored{0.3f, 0.2f};
/// Scores at power 1 and costs of what comes before the first vertex and after each.
constexpr std::array<double, 3> kScore{0, 0.1, 0.2}, kCost{2, 3, 5};

/// Second moment times cost of paths that survive by `way`: a photon that comes with power 1 has
/// power 1 / s after a vertex, and is there with probability s.
double work(const Way& way) {
    double moment = 0, cost = kCost[0], power = 1, reached = 1;
    for (std::size_t v = 0; v < way.size(); ++v) {
        const auto s = double(limited_survival(way[v] * float(power)));
        power /= s;
        reached *= s;
        moment += reached * kScore[v + 1] * power * power;
        cost += reached * kCost[v + 1];
    }
    return moment * cost;
}

/// Paths traced by `way`.
double estimated_gain(const Way& way, int paths, std::uint64_t seed) {
    SurvivalSwitch judge;
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < paths; ++i) {
        SurvivalSwitch::Path path;
        path.add(kScore[0], kCost[0]);
        double power = 1;
        for (std::size_t v = 0; v < way.size(); ++v) {
            Survival s;
            s.plain = kPlain[v] * float(power);
            s.scored = kScored[v] * float(power);
            s.probability = limited_survival(way[v] * float(power));
            if (random.next() >= s.probability) break;
            path.survive(s);
            power /= double(s.probability);
            path.add(kScore[v + 1] * power * power, kCost[v + 1]);
        }
        judge.add(path);
    }
    return judge.gain();
}

/// The looking up of scores costs a little that work() leaves out: at most 0.4 rays of 2 and more.
void expect_gain(double gain) {
    const double expected = work(kPlain) / work(kScored);
    EXPECT_LT(gain, 1.02 * expected);
    EXPECT_GT(gain, 0.85 * expected);
}

TEST(SurvivalSwitch, GainFromPathsOfThePlainWay) {
    expect_gain(estimated_gain(kPlain, 400000, 1));
}

TEST(SurvivalSwitch, GainFromPathsOfTheScoredWay) {
    expect_gain(estimated_gain(kScored, 400000, 2));
}

TEST(SurvivalSwitch, WhereNothingIsKnownBothWaysAreThePlainOne) {
    SurvivalSwitch judge;
    SurvivalSwitch::Path path;
    path.add(1, 2);
    path.survive({.probability = 0.5f, .plain = 0.5f, .scored = -1});
    path.add(1, 2);
    judge.add(path);
    EXPECT_LT(judge.gain(), 1);  // for looking up in vain
    EXPECT_GT(judge.gain(), 0.9);
}

TEST(SurvivalSwitch, IsOnAtFirstAndGoesOffWhereItDoesNotPay) {
    SurvivalSwitch judge;
    EXPECT_TRUE(judge.on());
    const auto learn = [&](float plain, float scored) {
        for (int i = 0; i < 1000; ++i) {
            SurvivalSwitch::Path path;
            path.add(0, 1);
            path.survive({.probability = plain, .plain = plain, .scored = scored});
            path.add(1, 10);
            judge.add(path);
        }
        judge.update(1e5, 4e6);
    };
    learn(1, 0.05f);
    EXPECT_FALSE(judge.on());
}

}  // namespace
