// Protects the choice of who carries light: shares by the inverse of variances, photons as few or
// many as make error times cost least, nothing for the eye where it does not find what photons do.
#include "plan/pass_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan/constants.h"
#include "state/memory_archive.h"

namespace aips::pass_plan_test {
namespace {

constexpr double kPaths = 10000, kPoints = 1000;

/// A leaf of light of radiance 1. Per photon path its photons' variance, per continued path the
/// eye's; `others`: of light that photons alone carry.
ShareMoments leaf(double photons, double eye, double others = 0, double rays = 4) {
    ShareMoments m;
    m.population = m.points = m.continued = 1000;
    m.squares = 1000 * photons;
    m.others = 1000 * others;
    m.x = m.y = m.xy = 1000;
    m.xx = 1000 * (1 + photons / kPaths);
    m.yy = 1000 * (1 + eye);
    m.spread = 1000 * photons;
    m.rays = 1000 * rays;
    return m;
}

PlanFacts facts_of(const std::vector<ShareMoments>& leaves, const std::vector<EyeShare>& shares,
                   double eye_noise) {
    PlanFacts facts{leaves, shares};
    facts.passes_until = 0;
    facts.points = kPoints;
    facts.point_weight = 1 / kPoints;
    facts.photon_paths = kPaths;
    facts.eye_cost = 3000;
    facts.photon_path_cost = 1;
    facts.ray_cost = 1;
    facts.variance = eye_noise;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const double a = double(shares[i].share), n = double(leaves.size());
        const ShareMoments& m = leaves[i];
        facts.variance += (1 - a) * (1 - a) * m.squares / m.points / kPaths / n;
        facts.variance += m.others / m.points / kPaths / n;
    }
    return facts;
}

/// Of the eye where photons and continued paths leave such variances.
double best_share(double photons, double eye) {
    return photons / (photons + kStratifiedPaths * eye);
}

constexpr PhotonLimits kFixed{kPaths, kPaths}, kFree{kPaths / 32, 4 * kPaths};

TEST(PassPlan, SharesGoByTheInverseOfTheVariances) {
    const std::vector<ShareMoments> leaves{leaf(3 * kPaths, 1), leaf(kPaths / 100, 1)};
    const std::vector<EyeShare> shares(2);
    const PassPlan plan = plan_passes(facts_of(leaves, shares, 0.1), kFixed);
    EXPECT_NEAR(plan.shares[0].share, best_share(3, 1), 1e-6);
    EXPECT_EQ(plan.shares[1].share, 0) << "one per cent of variance does not pay its rays";
    EXPECT_EQ(plan.photon_paths, kPaths);
    EXPECT_NEAR(plan.going_on, 0.5, 1e-9);
    EXPECT_NEAR(plan.eye_share, best_share(3, 1), 1e-6);
}

TEST(PassPlan, BiasOfPhotonsIsAnErrorToo) {
    const std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    PlanFacts facts = facts_of(leaves, shares, 0.01);
    EXPECT_NEAR(plan_passes(facts, kFixed).shares[0].share, best_share(1, 1), 1e-6);
    facts.squared_error = 1.5;
    EXPECT_NEAR(plan_passes(facts, kFixed).shares[0].share, best_share(1.5, 1), 1e-6);
}

TEST(PassPlan, PhotonsBecomeFewWhereEyePathsCarryTheLight) {
    const std::vector<ShareMoments> leaves{leaf(100 * kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    const PassPlan plan = plan_passes(facts_of(leaves, shares, 0.1), kFree);
    EXPECT_GT(plan.shares[0].share, 0.95f);
    EXPECT_NEAR(plan.photon_paths, kFree.fewest, 1);
}

/// Of light that specular surfaces focus eye paths find nothing.
TEST(PassPlan, PhotonsStayForLightThatIsTheirsAlone) {
    const std::vector<ShareMoments> leaves{leaf(kPaths / 100, 5, 10 * kPaths)};
    const std::vector<EyeShare> shares(1);
    const PassPlan plan = plan_passes(facts_of(leaves, shares, 0.1), kFree);
    EXPECT_EQ(plan.shares[0].share, 0);
    EXPECT_GT(plan.photon_paths, kPaths);
}

TEST(PassPlan, LightThatPathsMissIsNotTheirs) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].y = leaves[0].xy = leaves[0].yy = 0;  // not one has met it
    EXPECT_EQ(plan_passes(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0);
    leaves[0] = leaf(kPaths, 1);
    leaves[0].y = leaves[0].xy = 100;  // or a tenth of it
    leaves[0].yy = 200;
    EXPECT_LT(plan_passes(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0.01f);
    leaves[0] = leaf(kPaths, 1);
    leaves[0].yy = 1e6;  // or all of it by one path
    EXPECT_EQ(plan_passes(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0);
}

/// Their variance is not known at all then, and that of the eye's, by a single path, roughly is.
TEST(PassPlan, LightThatNoPhotonFoundIsTheEyes) {
    std::vector<ShareMoments> leaves{leaf(0, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].x = leaves[0].xx = leaves[0].xy = leaves[0].spread = 0;
    leaves[0].y = 100;  // one path of a thousand
    leaves[0].yy = 1e4;
    PlanFacts facts = facts_of(leaves, shares, 0);
    EXPECT_GT(plan_passes(facts, kFree).shares[0].share, 0.96f);
    facts.leaves[0].squares = 1e-3;  // and where some came, it is known
    EXPECT_EQ(plan_passes(facts, kFree).shares[0].share, 0);
    facts.leaves[0].squares = facts.leaves[0].y = facts.leaves[0].yy = 0;  // neither found any
    EXPECT_EQ(plan_passes(facts, kFree).shares[0].share, 0);
}

/// Photons of chains come in clusters, which squares of single ones do not tell.
TEST(PassPlan, ClusteredPhotonsAreTakenAsNoisyAsTheyAre) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].squares /= 50;
    PlanFacts facts = facts_of(leaves, shares, 0.1);
    EXPECT_LT(plan_passes(facts, kFixed).shares[0].share, 0.02f);
    facts.independent = false;
    EXPECT_NEAR(plan_passes(facts, kFixed).shares[0].share, best_share(1, 1), 1e-6);
}

/// Near a large light shadow rays alone are noisier than the light that photons bring.
TEST(PassPlan, BsdfSampledDirectLightIsChosenWhereItPays) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1), leaf(kPaths / 1e5, 1)};
    const std::vector<EyeShare> shares(2);
    EXPECT_EQ(plan_passes(facts_of(leaves, shares, 20), kFixed).bsdf_direct, 0);
    leaves[1].direct_saved = leaves[1].continued * 30;
    const PassPlan plan = plan_passes(facts_of(leaves, shares, 20), kFixed);
    EXPECT_EQ(plan.shares[0], EyeShare{});
    EXPECT_EQ(plan.shares[1], EyeShare{.bsdf_direct = true});
    EXPECT_EQ(plan.going_on, 0);
    EXPECT_DOUBLE_EQ(plan.bsdf_direct, 0.5);
    EXPECT_DOUBLE_EQ(plan.cost, 3000 + kPaths + kPoints / 2);
    // The choice is the same once they do, and the noise is gone.
    EXPECT_EQ(plan_passes(facts_of(leaves, plan.shares, 5), kFixed).shares, plan.shares);
    // What is said to be gained is no more than there is.
    leaves[1].direct_saved = leaves[1].continued * 1e9;
    EXPECT_GT(plan_passes(facts_of(leaves, shares, 20), kFixed).error, 0);
}

/// One sample close to a lamp told a gain of 35 times all noise in furnace, and photons were cut to
/// a fifteenth: what sharing has gained is no noise that passes have.
TEST(PassPlan, WhatDirectLightHasGainedIsNotThereAnyMore) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 30), leaf(kPaths, 30)};
    const std::vector<EyeShare> shares(2, EyeShare{.bsdf_direct = true});
    const auto plan_with = [&](double gain) {
        leaves[0].direct_saved = leaves[0].continued * gain;
        leaves[1].direct_saved = leaves[1].continued * 30;
        return plan_passes(facts_of(leaves, shares, 0.5), kFree);
    };
    const PassPlan usual = plan_with(30), spoiled = plan_with(1e6);
    EXPECT_EQ(spoiled.shares, usual.shares);
    EXPECT_EQ(spoiled.shares, shares);
    EXPECT_EQ(spoiled.photon_paths, usual.photon_paths);
    EXPECT_NEAR(spoiled.error, usual.error, 1e-6);
}

/// Wide radii lose light, which no number of passes makes good.
TEST(PassPlan, LightThatPhotonsLoseIsAnError) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    const auto share_after = [&](double passes, double photons) {
        leaves[0].x = leaves[0].xy = 1000 * photons;
        PlanFacts facts = facts_of(leaves, shares, 0.01);
        facts.passes_until = passes;
        facts.counts_loss = true;
        return double(plan_passes(facts, kFixed).shares[0].share);
    };
    EXPECT_NEAR(share_after(0, 0.8), best_share(1, 1.2), 1e-6);
    EXPECT_NEAR(share_after(64, 0.8), best_share(1 + 64 * 0.04 * 0.8, 1.2), 1e-6);
    EXPECT_NEAR(share_after(256, 0.8), best_share(1 + 256 * 0.04 * 0.8, 1.2), 1e-6);
    EXPECT_NEAR(share_after(256, 0.98), best_share(1, 1.02), 1e-6) << "that may be chance";
    EXPECT_NEAR(share_after(256, 1.2), best_share(1, 0.8), 1e-6) << "paths miss light, or seem to";
}

/// Grass loses a third of its light, the wall behind it none: the loss of all is not that of each.
TEST(PassPlan, ALeafThatLosesLightIsToldFromOthers) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1), leaf(kPaths, 1)};
    leaves[0].x = leaves[0].xy = 600;
    leaves[0].population = 10;
    const std::vector<EyeShare> shares(2);
    PlanFacts facts = facts_of(leaves, shares, 0.01);
    facts.passes_until = 64;
    facts.counts_loss = true;
    const PassPlan plan = plan_passes(facts, kFixed);
    // As much as its own samples are sure of: three standard errors of 1000 pairs.
    const double square = (leaves[0].xx + leaves[0].yy - 2 * leaves[0].xy) / 1000;
    const double sure = 0.4 - kSureErrors * std::sqrt(square / 1000);
    EXPECT_NEAR(plan.shares[0].share, best_share(1 + 64 * sure * sure, 1.4), 1e-6);
    EXPECT_NEAR(plan.shares[1].share, best_share(1, 1), 1e-6);
}

/// A leaf of which a single path is known says nothing of light that photons lose.
TEST(PassPlan, OneBrightPathIsNoLightThatPhotonsLose) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1), leaf(kPaths, 1)};
    leaves[1].continued = 1;
    leaves[1].x = leaves[1].xx = leaves[1].xy = 1;
    leaves[1].y = 50;
    leaves[1].yy = 2500;
    const std::vector<EyeShare> shares(2);
    PlanFacts facts = facts_of(leaves, shares, 0.01);
    facts.passes_until = 256;
    const PassPlan without = plan_passes(facts, kFixed);
    facts.counts_loss = true;
    EXPECT_EQ(plan_passes(facts, kFixed).shares, without.shares);
}

/// Where a path has no second ray, as under an open sky, a first one is all of it.
TEST(PassPlan, PathsOfOneRayGoOnForTheSakeOfDirectLight) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1, 0, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    EXPECT_EQ(plan_passes(facts_of(leaves, shares, 20), kFixed).shares[0],
              EyeShare{.share = float(kLeastEyeShare)});
}

TEST(PassPlan, WholePathsFollowBsdfSampledDirectLightWhereTheirLightPaysToo) {
    std::vector<ShareMoments> leaves{leaf(3 * kPaths, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    const PassPlan plan = plan_passes(facts_of(leaves, shares, 20), kFixed);
    EXPECT_NEAR(plan.shares[0].share, best_share(3, 1), 1e-6);
    EXPECT_FALSE(plan.shares[0].bsdf_direct);
    EXPECT_DOUBLE_EQ(plan.cost, 3000 + kPaths + kPoints * 4);
}

/// Squares of rare light say more than passes differ by, and would leave nothing to be gained.
TEST(PassPlan, NoiseOfWhatEyePathsBringIsNoRemainder) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    PlanFacts facts = facts_of(leaves, shares, 0);
    EXPECT_EQ(plan_passes(facts, kFixed).bsdf_direct, 0);
    facts.own_variance = 20;
    EXPECT_EQ(plan_passes(facts, kFixed).bsdf_direct, 1);
}

TEST(PassPlan, NothingKnownIsNothingShared) {
    const std::vector<ShareMoments> leaves(6);
    const std::vector<EyeShare> shares(6);
    PlanFacts facts{leaves, shares};
    facts.photon_paths = kPaths;
    const PassPlan plan = plan_passes(facts, kFixed);
    for (const EyeShare& share : plan.shares)
        EXPECT_EQ(share, EyeShare{});
    EXPECT_EQ(plan.photon_paths, kPaths);
}

/// From a share m of L on with M m^2 L^2 > m (E[Y^2] + E / C cost), here L = 1.
TEST(PassPlan, EyePathsBringWhatPhotonsLoseAtEdgesWherePassesAverageTheirNoise) {
    const std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 3), leaf(kPaths / 1e5, 100)};
    const std::vector<EyeShare> shares(2);
    PlanFacts facts = facts_of(leaves, shares, 0);
    facts.passes_until = 40;
    facts.ray_cost = 0;
    PassPlan plan = plan_passes(facts, kFixed);
    EXPECT_NEAR(plan.shares[0].fills_from, 4.0 / 40, 1e-5);
    EXPECT_FALSE(plan.shares[1].may_fill()) << "too noisy for so few passes";
    facts.passes_until = 4000;
    facts.ray_cost = 1;
    plan = plan_passes(facts, kFixed);
    const double cost = plan.error / plan.cost / facts.point_weight * 4;
    EXPECT_NEAR(plan.shares[0].fills_from, (4 + cost) / 4000, 1e-5);
    EXPECT_NEAR(plan.shares[1].fills_from, (101 + cost) / 4000, 1e-5);
}

/// Where the eye does nearly all, shooting in one of several passes saves what it costs in itself;
/// not where photons bring a part of the image that would then come and go.
TEST(PassPlan, OnePassShootsForSeveralWherePhotonsBringLittle) {
    const std::vector<ShareMoments> leaves{leaf(kPaths, 0.1)};
    const std::vector<EyeShare> shares(1);
    PlanFacts facts = facts_of(leaves, shares, 0.1);
    facts.shooting_cost = 1000;
    const PhotonLimits in_turns{kPaths, kPaths, 8};
    EXPECT_EQ(plan_passes(facts, kFixed).turns, 1u);
    EXPECT_EQ(plan_passes(facts, in_turns).turns, 8u);
    facts.photon_square = 1;
    EXPECT_EQ(plan_passes(facts, in_turns).turns, 1u);
    facts.photon_square = 0;
    facts.shooting_cost = 0;
    EXPECT_EQ(plan_passes(facts, in_turns).turns, 1u);
}

/// The same plan is made of facts that were saved: all that it depends on is in them.
TEST(PassPlan, IsMadeAgainOfSavedFacts) {
    const std::vector<ShareMoments> leaves{leaf(3 * kPaths, 1), leaf(kPaths / 100, 1, 7, 2)};
    PlanFacts facts =
        facts_of(leaves, {EyeShare{.share = 0.25f}, EyeShare{.bsdf_direct = true}}, 0.1);
    facts.passes = 3;
    facts.passes_until = 16;
    facts.counts_loss = true;
    facts.points_per_pixel = 2;
    facts.own_variance = 0.07;
    facts.photon_path_variance = 12;
    facts.turns = 2;
    facts.shooting_cost = 500;
    facts.photon_square = 0.01;
    facts.independent = false;
    facts.squared_error = 1.5;
    mock::Saving saving;
    facts.state(saving);
    mock::Restoring restoring(saving.saved());
    PlanFacts again;
    again.state(restoring);
    EXPECT_EQ(restoring.remaining(), 0u);
    const PhotonLimits limits{kPaths / 32, 4 * kPaths, 8};
    const PassPlan first = plan_passes(facts, limits), second = plan_passes(again, limits);
    EXPECT_EQ(first.shares, second.shares);
    EXPECT_EQ(first.photon_paths, second.photon_paths);
    EXPECT_EQ(first.turns, second.turns);
    EXPECT_EQ(first.error, second.error);
    EXPECT_EQ(first.cost, second.cost);
    EXPECT_EQ(first.going_on, second.going_on);
}

}  // namespace
}  // namespace aips::pass_plan_test
