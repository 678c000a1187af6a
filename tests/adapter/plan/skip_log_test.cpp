// Protects what is skipped while a render goes on: an adaptive guide that does not pay rests, and
// the log says so once; what it prunes is told.
#include "plan/skip_log.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "eye/light_choice.h"
#include "render_mock.h"

namespace aips::skip_log_test {
namespace {

/// A guide for a box, and what it learns of made-up paths.
struct Learner {
    explicit Learner(const Settings& s)
        : scene(mock::lamp_box({}, {})),
          settings(s),
          choice(light_choice(scene)),
          importance(8, 8),
          guide(scene, settings, choice, importance) {}

    /// `paths` photon paths of which one in `one_of` was scored, and brought nothing.
    void learn_nothing(std::uint32_t paths, std::uint32_t one_of) {
        PathLog log;
        log.paths.resize(paths / one_of);
        for (PathRecord& path : log.paths) {
            path.pdf = 1;
            path.rays = 1;
        }
        guide.study(log);
        guide.update(paths);
    }

    mock::Scene scene;
    Settings settings;
    DiscreteDistribution choice;
    PixelImportance importance;
    AdaptiveGuide guide;
};

Settings survival_alone() {
    Settings settings = mock::small_settings(1, 1);
    settings.guide = GuideKind::Adaptive;
    settings.guide_emission = false;
    return settings;
}

/// Of how many paths one is logged in the pass that begins.
std::uint32_t log_one_of_next_pass(Learner& learner) {
    learner.guide.begin_pass(1, 0, {}, {}, 0.1f);
    return learner.guide.log_one_of();
}

/// What has met nothing that is worth anything has not been tried yet.
TEST(DisabledGuide, GoesOnWhileNothingIsKnown) {
    Settings settings = survival_alone();
    settings.guide_emission = true;
    Learner learner(settings);
    EXPECT_EQ(log_one_of_next_pass(learner), 4u);
    learner.learn_nothing(1'000'000, 4);
    EXPECT_FALSE(learner.guide.disabled());
    EXPECT_EQ(log_one_of_next_pass(learner), 16u);
}

/// With its parts switched off by the user it only measures, at the usual rate.
TEST(DisabledGuide, IsNotOneThatOnlyMeasures) {
    Settings settings = survival_alone();
    settings.guide_survival = false;
    Learner learner(settings);
    learner.learn_nothing(1'000'000, 4);
    EXPECT_EQ(learner.guide.log_one_of(), 16u);
}

/// In an evenly lit box there is nothing to gain.
TEST(DisabledGuide, LearnsNothingWhereNoPartPays) {
    Settings settings = mock::small_settings(4, 300'000);
    settings.guide = GuideKind::Adaptive;
    const auto r = mock::render(mock::lamp_box({}, {}),
                                mock::camera_along_y({0, -0.95f, 0}, 1, 8, 8), 8, 8, settings, 5);
    const auto said = [&](const std::string& line) {
        return std::count(r.log.lines.begin(), r.log.lines.end(), line);
    };
    EXPECT_EQ(said("skipped the guide's learning, but for trials: no part of it pays"), 1);
}

TEST(SkipLog, NamesWhatIsSwitchedOffOnce) {
    Learner learner(survival_alone());
    mock::Log log;
    SkipLog skip_log(log);
    PhotonCounts photons;
    photons.paths = 400'000;
    learner.learn_nothing(400'000, 8);
    skip_log.after_pass(&learner.guide, photons);
    EXPECT_TRUE(log.lines.empty()) << "still tried";
    learner.learn_nothing(400'000, 4);
    skip_log.after_pass(&learner.guide, photons);
    skip_log.after_pass(&learner.guide, photons);
    ASSERT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines[0], "skipped survival by score for now: too little is gained, 1.00");
}

TEST(SkipLog, TellsWhyTheGuideIsLeftOut) {
    mock::Log log;
    SkipLog skip_log(log);
    skip_log.left_out_guide({8000, 7000, 16384});
    ASSERT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines[0],
              "skipped the guide: 49 % of the photon paths come near what is seen without it");
}

TEST(SkipLog, TellsWhatWasExplored) {
    mock::Log log;
    SkipLog skip_log(log);
    skip_log.explored({{}, 262'144});
    skip_log.explored({{EmissionSeed{}}, 65'536});
    ASSERT_EQ(log.lines.size(), 2u);
    EXPECT_EQ(log.lines[0], "explored: none of 262144 photon paths is seen");
    EXPECT_EQ(log.lines[1], "explored: 65536 photon paths told where those start that are seen");
}

/// What nobody asked for was not tried.
TEST(SkipLog, SaysNothingOfPartsThatAreNotThere) {
    Settings settings = survival_alone();
    settings.guide_survival = false;
    Learner learner(settings);
    mock::Log log;
    SkipLog skip_log(log);
    learner.learn_nothing(800'000, 4);
    skip_log.after_pass(&learner.guide, {});
    EXPECT_TRUE(log.lines.empty());
}

TEST(SkipLog, TellsWhoCarriesWhatWhereItChanges) {
    mock::Log log;
    SkipLog skip_log(log);
    PassPlan plan;
    plan.photon_paths = 5000;
    skip_log.planned(plan);
    EXPECT_TRUE(log.lines.empty()) << "photons alone, as at the start";
    plan.going_on = 0.5;
    plan.eye_share = 0.75;
    skip_log.planned(plan);
    skip_log.planned(plan);
    ASSERT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines[0],
              "eye paths go on from 50 % of the surfaces seen that take photons, and carry 75 % of "
              "the light there that both can; 5000 photon paths a pass");
    plan.going_on = 0;
    skip_log.planned(plan);
    ASSERT_EQ(log.lines.size(), 2u);
    EXPECT_EQ(log.lines[1],
              "photons carry all indirect light to surfaces that take them; 5000 photon paths a "
              "pass");
}

TEST(SkipLog, TellsWhatIsPruned) {
    Learner learner(survival_alone());
    mock::Log log;
    SkipLog skip_log(log);
    PhotonCounts photons;
    photons.paths = 1'000'000;
    photons.pruned = 130'000;
    skip_log.after_pass(&learner.guide, photons);
    skip_log.after_pass(&learner.guide, photons);
    ASSERT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines[0],
              "pruned: 0 % of what lights emit gets under a quarter of its photons, 13 % of the "
              "photon paths were ended by their score");
    skip_log.after_pass(nullptr, photons);
    EXPECT_EQ(log.lines.size(), 1u);
}

}  // namespace
}  // namespace aips::skip_log_test
