// Protects the choice of who carries light: shares by the inverse of variances, photons as few or
// many as make error times cost least, nothing for the eye where it does not find what photons do.
#include "plan/share_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan/constants.h"

namespace aips::share_plan_test {
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

ShareFacts facts_of(std::span<const ShareMoments> leaves, std::span<const EyeShare> shares,
                    double eye_noise) {
    ShareFacts facts{leaves, shares};
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

TEST(SharePlan, SharesGoByTheInverseOfTheVariances) {
    const std::vector<ShareMoments> leaves{leaf(3 * kPaths, 1), leaf(kPaths / 100, 1)};
    const std::vector<EyeShare> shares(2);
    const SharePlan plan = plan_shares(facts_of(leaves, shares, 0.1), kFixed);
    EXPECT_NEAR(plan.shares[0].share, best_share(3, 1), 1e-6);
    EXPECT_EQ(plan.shares[1].share, 0) << "one per cent of variance does not pay its rays";
    EXPECT_EQ(plan.photon_paths, kPaths);
    EXPECT_NEAR(plan.going_on, 0.5, 1e-9);
    EXPECT_NEAR(plan.eye_share, best_share(3, 1), 1e-6);
}

TEST(SharePlan, BiasOfPhotonsIsAnErrorToo) {
    const std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    ShareFacts facts = facts_of(leaves, shares, 0.01);
    EXPECT_NEAR(plan_shares(facts, kFixed).shares[0].share, best_share(1, 1), 1e-6);
    facts.squared_error = 1.5;
    EXPECT_NEAR(plan_shares(facts, kFixed).shares[0].share, best_share(1.5, 1), 1e-6);
}

TEST(SharePlan, PhotonsBecomeFewWhereEyePathsCarryTheLight) {
    const std::vector<ShareMoments> leaves{leaf(100 * kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    const SharePlan plan = plan_shares(facts_of(leaves, shares, 0.1), kFree);
    EXPECT_GT(plan.shares[0].share, 0.95f);
    EXPECT_NEAR(plan.photon_paths, kFree.fewest, 1);
}

/// Of light that smooth surfaces focus eye paths find nothing.
TEST(SharePlan, PhotonsStayForLightThatIsTheirsAlone) {
    const std::vector<ShareMoments> leaves{leaf(kPaths / 100, 5, 10 * kPaths)};
    const std::vector<EyeShare> shares(1);
    const SharePlan plan = plan_shares(facts_of(leaves, shares, 0.1), kFree);
    EXPECT_EQ(plan.shares[0].share, 0);
    EXPECT_GT(plan.photon_paths, kPaths);
}

TEST(SharePlan, LightThatPathsMissIsNotTheirs) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].y = leaves[0].xy = leaves[0].yy = 0;  // not one has met it
    EXPECT_EQ(plan_shares(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0);
    leaves[0] = leaf(kPaths, 1);
    leaves[0].y = leaves[0].xy = 100;  // or a tenth of it
    leaves[0].yy = 200;
    EXPECT_LT(plan_shares(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0.01f);
    leaves[0] = leaf(kPaths, 1);
    leaves[0].yy = 1e6;  // or all of it by one path
    EXPECT_EQ(plan_shares(facts_of(leaves, shares, 0.1), kFixed).shares[0].share, 0);
}

/// Their variance is not known at all then, and that of the eye's, by a single path, roughly is.
TEST(SharePlan, LightThatNoPhotonFoundIsTheEyes) {
    std::vector<ShareMoments> leaves{leaf(0, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].x = leaves[0].xx = leaves[0].xy = leaves[0].spread = 0;
    leaves[0].y = 100;  // one path of a thousand
    leaves[0].yy = 1e4;
    ShareFacts facts = facts_of(leaves, shares, 0);
    EXPECT_GT(plan_shares(facts, kFree).shares[0].share, 0.96f);
    leaves[0].squares = 1e-3;  // and where some came, it is known
    EXPECT_EQ(plan_shares(facts, kFree).shares[0].share, 0);
    leaves[0].squares = leaves[0].y = leaves[0].yy = 0;  // neither found any
    EXPECT_EQ(plan_shares(facts, kFree).shares[0].share, 0);
}

/// Photons of chains come in clusters, which squares of single ones do not tell.
TEST(SharePlan, ClusteredPhotonsAreTakenAsNoisyAsTheyAre) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    leaves[0].squares /= 50;
    ShareFacts facts = facts_of(leaves, shares, 0.1);
    EXPECT_LT(plan_shares(facts, kFixed).shares[0].share, 0.02f);
    facts.independent = false;
    EXPECT_NEAR(plan_shares(facts, kFixed).shares[0].share, best_share(1, 1), 1e-6);
}

/// Near a large light shadow rays alone are noisier than the light that photons bring.
TEST(SharePlan, AFirstRayIsSentForTheSakeOfDirectLight) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1), leaf(kPaths / 1e5, 1)};
    const std::vector<EyeShare> shares(2);
    EXPECT_EQ(plan_shares(facts_of(leaves, shares, 20), kFixed).first_rays, 0);
    leaves[1].direct_saved = leaves[1].continued * 30;
    const SharePlan plan = plan_shares(facts_of(leaves, shares, 20), kFixed);
    EXPECT_EQ(plan.shares[0], EyeShare{});
    EXPECT_EQ(plan.shares[1], EyeShare{.first_ray = true});
    EXPECT_EQ(plan.going_on, 0);
    EXPECT_DOUBLE_EQ(plan.first_rays, 0.5);
    EXPECT_DOUBLE_EQ(plan.cost, 3000 + kPaths + kPoints / 2 * kFirstRays);
    // The choice is the same once they do, and the noise is gone.
    EXPECT_EQ(plan_shares(facts_of(leaves, plan.shares, 5), kFixed).shares, plan.shares);
    // What is said to be gained is no more than there is.
    leaves[1].direct_saved = leaves[1].continued * 1e9;
    EXPECT_GT(plan_shares(facts_of(leaves, shares, 20), kFixed).error, 0);
}

/// One sample close to a lamp told a gain of 35 times all noise in furnace, and photons were cut to
/// a fifteenth: what sharing has gained is no noise that passes have.
TEST(SharePlan, WhatDirectLightHasGainedIsNotThereAnyMore) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 30), leaf(kPaths, 30)};
    const std::vector<EyeShare> shares(2, EyeShare{.first_ray = true});
    const auto plan_with = [&](double gain) {
        leaves[0].direct_saved = leaves[0].continued * gain;
        leaves[1].direct_saved = leaves[1].continued * 30;
        return plan_shares(facts_of(leaves, shares, 0.5), kFree);
    };
    const SharePlan usual = plan_with(30), spoiled = plan_with(1e6);
    EXPECT_EQ(spoiled.shares, usual.shares);
    EXPECT_EQ(spoiled.shares, shares);
    EXPECT_EQ(spoiled.photon_paths, usual.photon_paths);
    EXPECT_NEAR(spoiled.error, usual.error, 1e-6);
}

/// Wide radii lose light, which no number of passes makes good.
TEST(SharePlan, LightThatPhotonsLoseIsAnError) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1)};
    const std::vector<EyeShare> shares(1);
    const auto share_after = [&](double passes, double photons) {
        leaves[0].x = leaves[0].xy = 1000 * photons;
        ShareFacts facts = facts_of(leaves, shares, 0.01);
        facts.passes_until = passes;
        return double(plan_shares(facts, kFixed).shares[0].share);
    };
    EXPECT_NEAR(share_after(0, 0.8), best_share(1, 1.2), 1e-6);
    EXPECT_NEAR(share_after(64, 0.8), best_share(1 + 64 * 0.04 * 0.8, 1.2), 1e-6);
    EXPECT_NEAR(share_after(256, 0.8), best_share(1 + 256 * 0.04 * 0.8, 1.2), 1e-6);
    EXPECT_NEAR(share_after(256, 0.98), best_share(1, 1.02), 1e-6) << "that may be chance";
    EXPECT_NEAR(share_after(256, 1.2), best_share(1, 0.8), 1e-6) << "paths miss light, or seem to";
}

/// Grass loses a third of its light, the wall behind it none: the loss of all is not that of each.
TEST(SharePlan, ALeafThatLosesLightIsToldFromOthers) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1), leaf(kPaths, 1)};
    leaves[0].x = leaves[0].xy = 600;
    leaves[0].population = 10;
    const std::vector<EyeShare> shares(2);
    ShareFacts facts = facts_of(leaves, shares, 0.01);
    facts.passes_until = 64;
    const SharePlan plan = plan_shares(facts, kFixed);
    // As much as its own samples are sure of: three standard errors of 1000 pairs.
    const double square = (leaves[0].xx + leaves[0].yy - 2 * leaves[0].xy) / 1000;
    const double sure = 0.4 - kCertainlyMissing * std::sqrt(square / 1000);
    EXPECT_NEAR(plan.shares[0].share, best_share(1 + 64 * sure * sure, 1.4), 1e-6);
    EXPECT_NEAR(plan.shares[1].share, best_share(1, 1), 1e-6);
}

/// A leaf of which a single path is known says nothing of light that photons lose.
TEST(SharePlan, OneBrightPathIsNoLightThatPhotonsLose) {
    std::vector<ShareMoments> leaves{leaf(kPaths, 1), leaf(kPaths, 1)};
    leaves[1].continued = 1;
    leaves[1].x = leaves[1].xx = leaves[1].xy = 1;
    leaves[1].y = 50;
    leaves[1].yy = 2500;
    const std::vector<EyeShare> shares(2);
    ShareFacts facts = facts_of(leaves, shares, 0.01);
    const SharePlan without = plan_shares(facts, kFixed);
    facts.passes_until = 256;
    EXPECT_EQ(plan_shares(facts, kFixed).shares, without.shares);
}

/// Where a path has no second ray, as under an open sky, a first one is all of it.
TEST(SharePlan, PathsOfOneRayGoOnForTheSakeOfDirectLight) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1, 0, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    EXPECT_EQ(plan_shares(facts_of(leaves, shares, 20), kFixed).shares[0],
              EyeShare{.share = float(kLeastEyeShare)});
}

TEST(SharePlan, WholePathsFollowAFirstRayWhereTheirLightPaysToo) {
    std::vector<ShareMoments> leaves{leaf(3 * kPaths, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    const SharePlan plan = plan_shares(facts_of(leaves, shares, 20), kFixed);
    EXPECT_NEAR(plan.shares[0].share, best_share(3, 1), 1e-6);
    EXPECT_FALSE(plan.shares[0].first_ray);
    EXPECT_DOUBLE_EQ(plan.cost, 3000 + kPaths + kPoints * 4);
}

/// Squares of rare light say more than passes differ by, and would leave nothing to be gained.
TEST(SharePlan, NoiseOfWhatEyePathsBringIsNoRemainder) {
    std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 1)};
    leaves[0].direct_saved = leaves[0].continued * 30;
    const std::vector<EyeShare> shares(1);
    ShareFacts facts = facts_of(leaves, shares, 0);
    EXPECT_EQ(plan_shares(facts, kFixed).first_rays, 0);
    facts.own_variance = 20;
    EXPECT_EQ(plan_shares(facts, kFixed).first_rays, 1);
}

TEST(SharePlan, NothingKnownIsNothingShared) {
    const std::vector<ShareMoments> leaves(6);
    const std::vector<EyeShare> shares(6);
    ShareFacts facts{leaves, shares};
    facts.photon_paths = kPaths;
    const SharePlan plan = plan_shares(facts, kFixed);
    for (const EyeShare& share : plan.shares)
        EXPECT_EQ(share, EyeShare{});
    EXPECT_EQ(plan.photon_paths, kPaths);
}

/// Where the eye does nearly all, shooting in one of several passes saves what it costs in itself;
/// not where photons bring a part of the image that would then come and go.
/// From a share m of L on with M m^2 L^2 > m (E[Y^2] + E / C cost), here L = 1.
TEST(SharePlan, EyePathsBringWhatPhotonsLoseAtEdgesWherePassesAverageTheirNoise) {
    const std::vector<ShareMoments> leaves{leaf(kPaths / 1e5, 3), leaf(kPaths / 1e5, 100)};
    const std::vector<EyeShare> shares(2);
    ShareFacts facts = facts_of(leaves, shares, 0);
    facts.passes_to_come = 40;
    facts.ray_cost = 0;
    SharePlan plan = plan_shares(facts, kFixed);
    EXPECT_NEAR(plan.shares[0].fills_from, 4.0 / 40, 1e-5);
    EXPECT_FALSE(plan.shares[1].may_fill()) << "too noisy for so few passes";
    facts.passes_to_come = 4000;
    facts.ray_cost = 1;
    plan = plan_shares(facts, kFixed);
    const double cost = plan.error / plan.cost / facts.point_weight * 4;
    EXPECT_NEAR(plan.shares[0].fills_from, (4 + cost) / 4000, 1e-5);
    EXPECT_NEAR(plan.shares[1].fills_from, (101 + cost) / 4000, 1e-5);
}

TEST(SharePlan, OnePassShootsForSeveralWherePhotonsBringLittle) {
    const std::vector<ShareMoments> leaves{leaf(kPaths, 0.1)};
    const std::vector<EyeShare> shares(1);
    ShareFacts facts = facts_of(leaves, shares, 0.1);
    facts.shooting_cost = 1000;
    const PhotonLimits in_turns{kPaths, kPaths, 8};
    EXPECT_EQ(plan_shares(facts, kFixed).turns, 1u);
    EXPECT_EQ(plan_shares(facts, in_turns).turns, 8u);
    facts.photon_square = 1;
    EXPECT_EQ(plan_shares(facts, in_turns).turns, 1u);
    facts.photon_square = 0;
    facts.shooting_cost = 0;
    EXPECT_EQ(plan_shares(facts, in_turns).turns, 1u);
}

}  // namespace
}  // namespace aips::share_plan_test
