// Protects the switch of roulette by score: what it thinks of either way is what that way is worth,
// whichever of them the paths were traced with.
#include "guides/adaptive/survival_switch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "aips/core/sampling/random.h"

namespace aips::survival_switch_test {
namespace {

/// What roulette by power and by score make of a photon of power 1 at the vertices of a path.
constexpr std::array<float, 2> kPlain{0.9f, 0.8f};
/// By score fewer photons go on, and then more; or more, and then fewer.
constexpr std::array<std::array<float, 2>, 2> kScored{{{0.1f, 3.0f}, {7.0f, 0.3f}}};
/// Scores at power 1 and costs of what comes before the first vertex and after each.
constexpr std::array<double, 3> kScore{0, 0.1, 0.2}, kCost{2, 3, 5};

Survival survival_at(std::size_t vertex, std::size_t scores, double power) {
    Survival s;
    s.plain = kPlain[vertex] * float(power);
    s.scored = kScored[scores][vertex] * float(power);
    return s;
}

/// Second moment times cost of paths that survive by `mix`: a photon that comes with power 1 has
/// power 1 / s after a vertex, and s photons are there.
double work(ScoreMix mix, std::size_t scores) {
    double moment = 0, cost = kCost[0], power = 1, photons = 1;
    for (std::size_t v = 0; v < kPlain.size(); ++v) {
        const auto s = double(photons_going_on(survival_at(v, scores, power), mix, 1));
        power /= s;
        photons *= s;
        moment += photons * kScore[v + 1] * power * power;
        cost += photons * kCost[v + 1];
    }
    return moment * cost;
}

/// The switch after paths that were traced by `mix`.
SurvivalSwitch judged(ScoreMix mix, std::size_t scores, std::uint64_t seed) {
    SurvivalSwitch judge;
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 400000; ++i) {
        SurvivalSwitch::Path path;
        path.add(kScore[0], kCost[0]);
        double power = 1;
        for (std::size_t v = 0; v < kPlain.size(); ++v) {
            Survival s = survival_at(v, scores, power);
            s.photons = photons_going_on(s, mix, 1);
            if (random.next() >= s.photons) break;  // above 1 the first photon goes on
            path.survive(s);
            power /= double(s.photons);
            path.add(kScore[v + 1] * power * power, kCost[v + 1]);
        }
        judge.add(path);
    }
    return judge;
}

// The looking up of scores costs a little that work() leaves out: at most 0.4 rays of 2 and more.
TEST(SurvivalSwitch, GainWhicheverWayThePathsWereTraced) {
    for (const std::size_t scores : {0u, 1u}) {
        const double half = work(ScoreMix::None, scores) / work(ScoreMix::Half, scores);
        const double quarters = work(ScoreMix::None, scores) / work(ScoreMix::Quarters, scores);
        const double expected = std::max(half, quarters);
        for (const ScoreMix mix : {ScoreMix::None, ScoreMix::Half, ScoreMix::Quarters}) {
            const double gain = judged(mix, scores, 1).gain();
            EXPECT_LT(gain, 1.03 * expected) << int(mix);
            EXPECT_GT(gain, 0.83 * expected) << int(mix);
        }
    }
}

TEST(SurvivalSwitch, WhereNothingIsKnownAllWaysAreThePlainOne) {
    SurvivalSwitch judge;
    SurvivalSwitch::Path path;
    path.add(1, 2);
    path.survive({.photons = 0.5f, .plain = 0.5f, .scored = -1});
    path.add(1, 2);
    for (std::size_t i = 0; i < SecondMoments::kGroups; ++i)
        judge.add(path);
    // A look-up for each of two rays, in vain.
    EXPECT_NEAR(judge.gain(), 1 / (1 + kLookUpCost / 2), 1e-6);
}

/// What is chosen after paths that went on at their one vertex, which scores took for worth little
/// or much; where for little, they really brought `score_of_poor`, for much 1.
ScoreMix mix_after(double score_of_poor) {
    SurvivalSwitch judge;
    EXPECT_EQ(judge.mix(), ScoreMix::Half);
    for (int i = 0; i < 1000; ++i) {
        const bool poor = i % 2 == 0;
        SurvivalSwitch::Path path;
        path.add(0, 30);
        path.survive({.photons = 1, .plain = 1, .scored = poor ? 0.05f : 2.0f});
        path.add(poor ? score_of_poor : 1, 10);
        judge.add(path);
    }
    judge.update(1e5, 4e6);
    return judge.mix();
}

// Second moment times cost are 20 by power; 13.5, 15 and 36 by the half, 11.6, 15 and 60 by three
// quarters (and what looking up costs).
TEST(SurvivalSwitch, FollowsScoresAsFarAsItPays) {
    EXPECT_EQ(mix_after(0), ScoreMix::Quarters);
    EXPECT_EQ(mix_after(0.02), ScoreMix::Half);
    EXPECT_EQ(mix_after(0.3), ScoreMix::None);
}

}  // namespace
}  // namespace aips::survival_switch_test
