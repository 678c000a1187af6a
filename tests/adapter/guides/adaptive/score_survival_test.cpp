// Protects roulette by score: the probability that makes second moment times cost least, finite,
// and none where nothing is known; and which photons are split.
#include "guides/adaptive/score_survival.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mock_bsdf.h"
#include "photons/photon_roulette.h"
#include "render_mock.h"

namespace aips::score_survival_test {
namespace {

constexpr Vec3 kFloor{0.5f, 0.5f, 0}, kUp{0, 0, 1};

/// A cache that knows one mean score and cost for all vertices.
ScoreCache cache_of(double score, double cost) {
    ScoreCache cache(Bounds{{0, 0, 0}, {1, 1, 1}});
    for (int i = 0; i < 100; ++i)
        cache.add({kFloor, kUp, score, cost});
    cache.update(100);
    return cache;
}

TEST(ScoreSurvival, PowerTimesTheRootOfScoreOverCost) {
    const ScoreCache cache = cache_of(0.5, 8);
    ScoreSurvival survival(cache);
    survival.set_reference(4);
    for (const float power : {0.25f, 0.5f, 1.5f}) {
        const auto probability = survival.probability(kFloor, kUp, power);
        ASSERT_TRUE(probability);
        EXPECT_NEAR(*probability, power * std::sqrt(0.5 / 8 * 4), 1e-5);
    }
}

TEST(ScoreSurvival, StaysFiniteAndAboveZero) {
    const ScoreCache worthy = cache_of(100, 1), worthless = cache_of(0, 1);
    ScoreSurvival high(worthy), low(worthless);
    high.set_reference(4);
    low.set_reference(4);
    EXPECT_NEAR(high.probability(kFloor, kUp, 1).value(), 20, 1e-4);
    EXPECT_TRUE(std::isfinite(high.probability(kFloor, kUp, 1e38f).value()));
    EXPECT_EQ(high.probability(kFloor, kUp, 0), 0.0f);
    EXPECT_EQ(low.probability(kFloor, kUp, 1), 0.0f);  // known to be worth nothing
}

TEST(ScoreSurvival, NothingWhereNothingIsKnown) {
    const ScoreCache cache = cache_of(0.5, 8);
    ScoreSurvival survival(cache);
    EXPECT_FALSE(survival.probability(kFloor, kUp, 1)) << "without a reference";
    survival.set_reference(4);
    EXPECT_TRUE(survival.probability(kFloor, kUp, 1));
    survival.set_reference(0);
    EXPECT_FALSE(survival.probability(kFloor, kUp, 1));
    const ScoreCache unlearned(Bounds{{0, 0, 0}, {1, 1, 1}});
    ScoreSurvival blank(unlearned);
    blank.set_reference(4);
    EXPECT_FALSE(blank.probability(kFloor, kUp, 1));
    const ScoreCache costless = cache_of(0.5, 0);
    ScoreSurvival of_costless(costless);
    of_costless.set_reference(4);
    EXPECT_FALSE(of_costless.probability(kFloor, kUp, 1));
}

/// A path of second moment A + q P^2 / s and cost B + c s: with its own whole cost over score for
/// a reference, the probability is where the product is least.
TEST(ScoreSurvival, ProductOfSecondMomentAndCostIsLeast) {
    constexpr double kScore = 2, kCost = 3, kPower = 0.7, kOtherScore = 12, kOtherCost = 9;
    const auto moment = [&](double s) { return kOtherScore + kScore * kPower * kPower / s; };
    const auto cost = [&](double s) { return kOtherCost + kCost * s; };
    const ScoreCache cache = cache_of(kScore, kCost);
    ScoreSurvival survival(cache);
    double s = 1;
    for (int i = 0; i < 100; ++i) {
        survival.set_reference(cost(s) / moment(s));
        s = double(survival.probability(kFloor, kUp, float(kPower)).value());
    }
    // The product's derivative by s is zero where s^2 = P^2 q B / (c A).
    EXPECT_NEAR(s, kPower * std::sqrt(kScore * kOtherCost / (kCost * kOtherScore)), 1e-4);
    for (const double other : {0.8 * s, 0.95 * s, 1.05 * s, 1.25 * s})
        EXPECT_GT(moment(other) * cost(other), moment(s) * cost(s)) << other << " beside " << s;
}

/// Photons that go on from a surface of this kind, by score, where one of power 1 is asked for as
/// `worth`^(1/2) of them.
float photons_from(mock::Material::Kind kind, double worth, bool split) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const ScoreCache cache = cache_of(worth, 1);
    ScoreSurvival survival(cache);
    survival.set_reference(1);
    PhotonInput input{scene, settings, lights};
    input.survival = &survival;
    input.score_mix = ScoreMix::Half;
    mock::Material material;
    material.kind = kind;
    material.reflectance = kWhite;
    material.specular = kWhite * 0.5f;
    Arena arena;
    SurfacePoint point;
    point.position = kFloor;
    point.geometric_normal = point.shading_normal = kUp;
    point.bsdf = mock::make_bsdf(material, kUp, kUp, arena);
    PhotonState photon;
    photon.ray.direction = normalize(Vec3{0.3f, 0.1f, -1});
    photon.power = kWhite;
    photon.emitted_power = 1;
    const Survival s = decide_survival(input, point, photon, false, split);
    EXPECT_EQ(s.photons, std::min(photons_going_on(s, ScoreMix::Half, 1), split ? 4.0f : 1.0f));
    return s.photons;
}

/// Parts of a photon go different ways from a diffuse lobe; specular lobes alone offer few, and
/// parts that take the same one fall on one point.
TEST(PhotonRoulette, SplitsWhereALobeSpreads) {
    using Kind = mock::Material::Kind;
    for (const Kind kind : {Kind::Lambert, Kind::Phong, Kind::LambertAndMirror}) {
        EXPECT_EQ(photons_from(kind, 1e4, true), kMostPhotons) << int(kind);
        EXPECT_EQ(photons_from(kind, 1e4, false), 1) << int(kind);
    }
    for (const Kind kind : {Kind::Mirror, Kind::Glass, Kind::Null})
        EXPECT_EQ(photons_from(kind, 1e4, true), 1) << int(kind);
    // Ended they are alike.
    for (const Kind kind : {Kind::Lambert, Kind::Mirror, Kind::Glass})
        EXPECT_NEAR(photons_from(kind, 1e-4, true), 0.1f, 1e-3f) << int(kind);
}

}  // namespace
}  // namespace aips::score_survival_test
