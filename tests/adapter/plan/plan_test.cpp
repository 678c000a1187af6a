// Protects the plan: one value says what runs, for every guide, mode and source of photons; it is
// printed, and saved with what the pilot pass decided.
#include "plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_mock.h"
#include "state/memory_archive.h"

namespace aips::plan_test {
namespace {

using testing::HasSubstr;

const mock::Scene& box() {
    static const mock::Scene scene = mock::lamp_box({}, {});
    return scene;
}

Plan plan_of(const Settings& settings) {
    return make_plan(box(), settings);
}

TEST(Plan, SaysWhatRuns) {
    Settings s;
    EXPECT_EQ(describe(plan_of(s)),
              "new eye paths in each pass; photon paths guided by their contribution, after a "
              "pilot pass, "
              "as many a pass as their noise asks for; radii by noise and bias");
    s.guide = GuideKind::Paper;
    EXPECT_EQ(describe(plan_of(s)),
              "new eye paths in each pass; photon paths guided by errors (Liu and Zheng 2014), as "
              "many a pass as their noise asks for; one radius, by the photons shot");
    s.guide = GuideKind::None;
    s.photon_sampler = PhotonSampler::AdaptiveChains;
    s.mode = Mode::Ppm;
    EXPECT_EQ(describe(plan_of(s)),
              "eye paths of one pass, kept; photon paths of Markov chains; radii by the photons of "
              "each visible point");
    s = {};
    s.max_photon_depth = 1;
    EXPECT_EQ(describe(plan_of(s)), "new eye paths in each pass; no photons");
}

// What is left out for the film's sake is not planned beside it.
TEST(Plan, FitsToTheFilm) {
    struct WithoutSplats final : ImageFilm {
        using ImageFilm::ImageFilm;
        bool takes_splats() const override { return false; }
    };
    Plan plan = plan_of({});
    plan.needs.settings.guide_emitters = true;
    plan.fit_to(mock::Film(4, 4, 1));
    EXPECT_THAT(describe(plan), HasSubstr("new eye paths and emitter paths in each pass"));
    Plan odd = plan;
    odd.needs.settings.hit_points_per_pass = 24;
    odd.fit_to(mock::Film(4, 4, 1));
    EXPECT_THAT(odd.needs.skipped.back(), HasSubstr("emitter paths: passes do not have the same"));
    plan.fit_to(WithoutSplats(4, 4, 1));
    EXPECT_THAT(describe(plan), HasSubstr("new eye paths in each pass;"));
    EXPECT_EQ(plan.needs.skipped.back(), "emitter paths: the film takes no splats");
}

TEST(Plan, AGuideThatIsLeftOutDoesNotLearn) {
    Plan plan = plan_of({});
    EXPECT_TRUE(plan.learns());
    plan.way = PhotonWay::Unguided;
    EXPECT_FALSE(plan.learns());
    EXPECT_TRUE(plan.measures_noise());
    EXPECT_TRUE(plan.has_pilot_pass()) << "a way that another render took is judged anew";
    EXPECT_EQ(plan.guide(), GuideKind::None);
}

TEST(Plan, LooksFirstOnlyWhereTheLookDecides) {
    Settings s;
    EXPECT_TRUE(plan_of(s).has_pilot_pass());
    s.pilot_pass = false;
    EXPECT_FALSE(plan_of(s).has_pilot_pass());
    s = {};
    s.guide = GuideKind::Paper;
    EXPECT_FALSE(plan_of(s).has_pilot_pass());
}

Plan restored(PhotonWay saved, const Settings& settings) {
    Plan plan = plan_of(settings);
    mock::Saving saving;
    StateArchive& archive = saving;
    archive.value(saved);
    mock::Restoring restoring(saving.saved());
    plan.state(restoring);
    return plan;
}

TEST(Plan, RestoresWhatTheLookDecidedAndNothingThatItCannotHave) {
    Settings s;
    EXPECT_EQ(restored(PhotonWay::Unguided, s).way, PhotonWay::Unguided);
    s.guide = GuideKind::None;
    EXPECT_THROW(restored(PhotonWay::Unguided, s), StateError);
    EXPECT_THROW(restored(PhotonWay(7), {}), StateError);
}

}  // namespace
}  // namespace aips::plan_test
