// Protects the photons of each pass where eye paths do not go on, as planner and schedule choose
// them: least variance times cost, weights that no noise moves, and what was asked for where it was
// asked for.
#include "plan/photon_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "guides/adaptive/learning_weight.h"
#include "plan/constants.h"
#include "plan/pass_planner.h"
#include "state/memory_archive.h"

namespace aips::photon_schedule_test {
namespace {

constexpr std::uint32_t kEyePaths = 20000;

/// A scene in which eye paths have variance `eye` and cost `eye_cost`, photon paths `photon_path`
/// and 1. Between passes eye paths differ by more than what is left of it.
struct Model {
    double eye, photon_path, eye_cost;

    /// Variance times cost of a pass.
    double work(double paths) const {
        return (kStratifiedEye * eye + photon_path / paths) * (eye_cost + paths);
    }
};

/// The passes of a render, one after the other.
class Render {
  public:
    Render(const Settings& settings, std::uint32_t eye_paths, bool learns)
        : schedule_(settings, eye_paths, true, learns), planner_(eye_paths, eye_paths) {}

    PhotonSchedule& schedule() { return schedule_; }
    const PassPhotons& next() const { return schedule_.next(); }
    void pass(const Model& model) {
        const auto paths = double(next().paths);
        planner_.add({.number = pass_,
                      .work = {model.eye_cost, paths},
                      .photon_paths = next().paths,
                      .noise = {model.eye + model.photon_path / paths, model.photon_path}});
        schedule_.end_pass();
        if (planner_.plans_before(++pass_))
            schedule_.take(plan_passes(planner_.take(pass_), schedule_.limits()));
    }

  private:
    PhotonSchedule schedule_;
    PassPlanner planner_;
    std::uint64_t pass_ = 0;
};

/// The passes that follow one another in such a scene.
std::vector<PassPhotons> passes(const Settings& settings, bool learns, const Model& model,
                                int count) {
    Render render(settings, kEyePaths, learns);
    std::vector<PassPhotons> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(render.next());
        render.pass(model);
    }
    return all;
}

// But for the steps of a root of two in which numbers are tried.
TEST(PhotonSchedule, VarianceTimesCostIsLeast) {
    for (const Model& model : {Model{1, 1e6, 1e5}, Model{0.01, 1e4, 3e4}, Model{5, 4e6, 1e5}}) {
        const auto chosen = double(passes({}, false, model, 300).back().paths);
        double least = model.work(chosen);
        for (double paths = 1 << 12; paths < 1 << 22; paths *= 1.01)
            least = std::min(least, model.work(paths));
        EXPECT_LT(model.work(chosen), 1.02 * least) << chosen;
    }
}

// Whatever noise says: photons take at most ten elevenths of the time.
TEST(PhotonSchedule, PhotonsDoNotTakeAllTheTime) {
    for (const double eye : {0.0, 1e-9}) {
        const auto many = double(passes({}, false, {eye, 1e9, 2e4}, 300).back().paths);
        EXPECT_GT(many, 10 * 2e4 / 2);
        EXPECT_LE(many, 10 * 2e4);
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
        Render render({}, eye_paths, true);
        for (int pass = 0; pass < 8; ++pass) {
            EXPECT_LE(render.next().weight, 1);
            render.pass({1, 1e6, 1});
        }
        EXPECT_EQ(render.next().weight, eye_paths > 100'000 ? 2 : 1);
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
        Render render({}, kEyePaths, learns);
        std::uint32_t last = 0;
        for (int i = 0; i < 300; ++i) {
            const std::uint32_t paths = render.next().paths;
            if (i > 0) {
                EXPECT_LE(paths, 2 * last);
                EXPECT_GE(32 * paths, last);
            }
            last = paths;
            // A scene that changes altogether.
            const bool many = i > 20 && i < 140;
            render.pass({1, many ? 1e15 : 1.0, 1e5});
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

// Of a warm start: whatever noise passes have, the first count for less, by
// their number alone.
TEST(PhotonSchedule, FirstPassesCountForLessAfterAWarmStart) {
    mock::Saving saving;
    {
        Render teacher({}, kEyePaths, true);
        for (int pass = 0; pass < 20; ++pass)
            teacher.pass({1, 1e6, 1e5});
        LearnedParts parts(saving);
        teacher.schedule().learned(parts);
        parts.end();
    }
    for (const double noise : {1.0, 1e9}) {
        mock::Restoring restoring(saving.saved());
        LearnedParts parts(restoring);
        Render warm_start({}, kEyePaths, true);
        warm_start.schedule().learned(parts);
        for (int pass = 0; pass < 20; ++pass) {
            const double known = std::min(1.0, (pass + 1) / double(kWarmUpPasses));
            EXPECT_DOUBLE_EQ(warm_start.next().weight, known * known) << pass;
            EXPECT_EQ(warm_start.next().counted, warm_start.next().paths);
            warm_start.pass({1, noise, 1e5});
        }
    }
}

}  // namespace
}  // namespace aips::photon_schedule_test
