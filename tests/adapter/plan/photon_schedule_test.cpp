// Protects the choice of the photons per pass: least variance times cost, weights that no noise
// moves, and what was asked for where it was asked for.
#include "plan/photon_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "guides/adaptive/learning_weight.h"
#include "plan/constants.h"
#include "state/memory_archive.h"

namespace aips::photon_schedule_test {
namespace {

constexpr std::uint32_t kEyePaths = 20000;

/// A scene in which eye paths have variance `eye` and cost `eye_cost`, photon paths `photon_path`
/// and 1.
struct Model {
    double eye, photon_path, eye_cost;

    /// Variance times cost of a pass.
    double work(double paths) const { return (eye + photon_path / paths) * (eye_cost + paths); }
};

/// The passes that follow one another in such a scene.
std::vector<PassPhotons> passes(const Settings& settings, bool learns, const Model& model,
                                int count) {
    PhotonSchedule schedule(settings, kEyePaths, true, learns);
    std::vector<PassPhotons> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(schedule.next());
        schedule.end_pass({model.eye_cost, double(all.back().paths)},
                          {model.eye, model.photon_path});
    }
    return all;
}

TEST(PhotonSchedule, VarianceTimesCostIsLeast) {
    for (const Model& model : {Model{1, 1e6, 1e5}, Model{0.01, 1e4, 3e4}, Model{5, 4e6, 1e5}}) {
        const auto chosen = double(passes({}, false, model, 100).back().paths);
        for (const double other : {0.5, 0.9, 1.1, 2.0})
            EXPECT_LT(model.work(chosen), model.work(other * chosen)) << chosen;
    }
}

// Whatever noise says: photons take between three fifths and ten elevenths of the time.
TEST(PhotonSchedule, NeitherSideTakesAllTheTime) {
    for (const double eye : {-1.0, 0.0, 1e-9}) {
        const auto many = double(passes({}, false, {eye, 1e9, 2e4}, 100).back().paths);
        EXPECT_NEAR(many / (10 * 2e4), 1, 1e-3);
    }
    for (const double photon_path : {-1.0, 0.0, 1e-9}) {
        const auto few = double(passes({}, false, {1, photon_path, 1e6}, 100).back().paths);
        EXPECT_NEAR(few / 1.5e6, 1, 1e-3);
    }
}

TEST(PhotonSchedule, PathsAreNumberedOneAfterTheOther) {
    for (const bool learns : {false, true}) {
        std::uint64_t before = 0;
        for (const PassPhotons& pass : passes({}, learns, {1, 1e12, 1e5}, 70)) {
            EXPECT_EQ(pass.before, before);
            before += pass.paths;
        }
    }
}

// The expectation of the image is that of a pass: what noise decides must not move weights.
TEST(PhotonSchedule, WeightsDependOnThePassAlone) {
    for (const bool learns : {false, true}) {
        const auto few = passes({}, learns, {1, 1, 1e5}, 70);
        const auto many = passes({}, learns, {1e-6, 1e9, 1e5}, 70);
        EXPECT_NE(few.back().paths, many.back().paths);
        double last = 0;
        for (std::size_t i = 0; i < few.size(); ++i) {
            EXPECT_EQ(few[i].weight, many[i].weight);
            EXPECT_GT(few[i].weight, 0);
            EXPECT_GE(few[i].weight, last);
            last = few[i].weight;
        }
        // Those before anything was known, or learned, count for less.
        EXPECT_GE(last, 8 * few[0].weight);
    }
}

// Those of large images have fewer photons at first than later, those of small ones more.
TEST(PhotonSchedule, AGuidesFirstPassesCountByTheImagesSize) {
    for (const std::uint32_t eye_paths : {20'000u, 500'000u}) {
        PhotonSchedule schedule({}, eye_paths, true, true);
        for (int pass = 0; pass < 8; ++pass) {
            EXPECT_LE(schedule.next().weight, 1);
            schedule.end_pass({1, 1}, {1, 1e6});
        }
        EXPECT_EQ(schedule.next().weight, eye_paths > 100'000 ? 2 : 1);
    }
}

TEST(PhotonSchedule, AGuideHasLearnedBeforeTheFirstChoice) {
    const auto all = passes({}, true, {1, 1, 1e5}, 20);
    for (const PassPhotons& pass : all) {
        if (double(pass.before) < kLearningPaths) {
            EXPECT_EQ(pass.paths, all[0].paths);
            EXPECT_LT(pass.counted, pass.paths);
        } else {
            EXPECT_EQ(pass.counted, pass.paths);
        }
    }
    EXPECT_NE(all.back().paths, all[0].paths);
}

// Passes count alike, whatever they cost.
TEST(PhotonSchedule, LaterChoicesFollowSlowly) {
    for (const bool learns : {false, true}) {
        PhotonSchedule schedule({}, kEyePaths, true, learns);
        std::uint32_t last = 0;
        for (int i = 0; i < 300; ++i) {
            const std::uint32_t paths = schedule.next().paths;
            if (i > 8) {
                EXPECT_LE(paths, 2 * last);
                EXPECT_GE(4 * paths, last);
            }
            last = paths;
            // A scene that changes altogether.
            const bool many = i > 20 && i < 70;
            schedule.end_pass({1e5, double(paths)}, {1, many ? 1e15 : 1.0});
        }
    }
}

TEST(PhotonSchedule, WhatWasAskedForStays) {
    Settings settings;
    settings.photons_per_pass = 12345;
    EXPECT_FALSE(PhotonSchedule(settings, kEyePaths, true, true).adapts());
    for (const PassPhotons& pass : passes(settings, false, {1, 1e12, 1e5}, 20)) {
        EXPECT_EQ(pass.paths, 12345u);
        EXPECT_EQ(pass.weight, 12345);
    }
}

// No pass is worth less than another where photons are not needed.
TEST(PhotonSchedule, NothingIsChosenWithoutPhotons) {
    EXPECT_FALSE(PhotonSchedule({}, kEyePaths, false, false).adapts());
}

// Frozen eye paths leave nothing to choose, and chains' noise is not that of single photons.
TEST(PhotonSchedule, AMillionWhereNoiseIsNotFollowed) {
    Settings frozen, chains;
    frozen.mode = Mode::PhotonMap;
    chains.photon_sampler = PhotonSampler::AdaptiveChains;
    for (const Settings& settings : {frozen, chains}) {
        EXPECT_FALSE(PhotonSchedule(settings, kEyePaths, true, false).adapts());
        EXPECT_EQ(passes(settings, false, {1, 1e12, 1e5}, 20).back().paths, 1'000'000u);
    }
}

// As if they had been shot: the first passes have fewer, and they count for more.
TEST(PhotonSchedule, PathsThatExploredCountAsLearnedFrom) {
    PhotonSchedule plain({}, 100, true, true), explored({}, 100, true, true);
    explored.explored(100'000);
    EXPECT_EQ(plain.next().paths, 62'500u);
    EXPECT_EQ(explored.next().paths, 50'000u);
    EXPECT_GT(explored.next().weight, plain.next().weight);
    PhotonSchedule unguided({}, 100, true, false);
    const PassPhotons before = unguided.next();
    unguided.explored(100'000);
    EXPECT_EQ(unguided.next().paths, before.paths);
    EXPECT_EQ(unguided.next().weight, before.weight);
}

// Of a render that was taught by another: whatever noise passes have, the first count for less, by
// their number alone.
TEST(PhotonSchedule, FirstPassesCountForLessWhereTheyWereTaught) {
    mock::Saving saving;
    {
        PhotonSchedule teacher({}, kEyePaths, true, true);
        for (int pass = 0; pass < 20; ++pass)
            teacher.end_pass({1e5, double(teacher.next().paths)}, {1, 1e6});
        LearnedParts parts(saving);
        teacher.learned(parts);
        parts.end();
    }
    for (const double noise : {1.0, 1e9}) {
        mock::Restoring restoring(saving.saved());
        LearnedParts parts(restoring);
        PhotonSchedule taught({}, kEyePaths, true, true);
        taught.learned(parts);
        for (int pass = 0; pass < 20; ++pass) {
            const double known = std::min(1.0, (pass + 1) / kTaughtPasses);
            EXPECT_DOUBLE_EQ(taught.next().weight, known * known) << pass;
            EXPECT_EQ(taught.next().counted, taught.next().paths);
            taught.end_pass({1e5, double(taught.next().paths)}, {1, noise});
        }
    }
}

}  // namespace
}  // namespace aips::photon_schedule_test
