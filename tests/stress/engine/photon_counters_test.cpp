// Protects: photon paths are numbered, traced and weighed as before where their numbers pass 2^32
// and 2^53: none is lost, none comes twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "eye/light_choice.h"
#include "guides/adaptive/learning_weight.h"
#include "guides/adaptive/part_switch.h"
#include "photons/photon_iteration.h"
#include "plan/constants.h"
#include "plan/pass_planner.h"
#include "plan/photon_schedule.h"
#include "render_mock.h"
#include "stress_case.h"

namespace photon_counters_test {
namespace {

using namespace aips;
using namespace stress;

constexpr std::uint64_t kOne = 1;
constexpr std::uint32_t kMost = 0xFFFFFFFFu;

/// Paths `first` and on of the pass that has `before` photon paths before it.
PhotonCounts trace(const mock::Scene& scene, std::uint64_t before, std::uint64_t pass,
                   std::uint32_t first, std::uint32_t count, PhotonStore& store) {
    Settings settings = mock::small_settings(31, kMost);
    settings.direct_light_sampling = false;
    const DiscreteDistribution lights = light_choice(scene);
    PhotonInput input{scene, settings, lights};
    input.pass = pass;
    InvalidSampleFilter filter(scene);
    return PhotonTracer().trace(input, before, first, count, filter, store);
}

TEST(StressCounters, ThePhotonsOfAPassAreAllTraced) {
    const mock::Scene scene = mock::lamp_box({}, {});
    for (const std::uint32_t count : {1u, 255u, 256u, 299u, 1000u}) {
        PhotonStore store;
        const PhotonCounts counts = trace(scene, 0, 0, kMost - count, count, store);
        EXPECT_EQ(counts.paths, count);
        ASSERT_FALSE(store.photons().empty());
        EXPECT_GE(store.photons().front().path, kMost - count);
        EXPECT_LT(store.photons().back().path, kMost);
    }
    record("the last 1 to 1000 of 2^32 - 1 photon paths in a pass", "all traced");
}

TEST(StressCounters, NoPhotonComesTwice) {
    const mock::Scene scene = mock::lamp_box({}, {});
    std::set<std::array<float, 3>> starts;
    std::size_t paths = 0;
    for (const std::uint64_t before :
         {kOne << 32, (kOne << 32) - 512, kOne << 53, kOne << 62, kOne - 1}) {
        for (const std::uint64_t pass : {kOne - 1, (kOne << 32) - 1, kOne << 32, kOne << 53}) {
            PhotonStore store;
            paths += trace(scene, before, pass, 0, 256, store).paths;
            std::uint32_t last = kMost;
            for (const Photon& l : store.photons()) {
                // What the bounces' stream decides: the second photon of each path.
                if (l.depth != 2 || l.path == last) continue;
                last = l.path;
                EXPECT_TRUE(starts.insert({l.position.x, l.position.y, l.position.z}).second)
                    << before << ' ' << pass << ' ' << l.path;
            }
        }
    }
    EXPECT_GT(starts.size(), paths / 4);
    record(
        std::to_string(paths) + " photon paths numbered about 0, 2^32, 2^53, 2^62 in passes as far",
        std::to_string(starts.size()) + " second photons, all different");
}

TEST(StressCounters, OfTheSchedule) {
    Settings settings;
    settings.photons_per_pass = kMost;
    for (const bool learns : {false, true}) {
        PhotonSchedule schedule(settings, 1000, true, learns);
        for (std::uint64_t pass = 0; pass < 6; ++pass) {
            const PassPhotons& photons = schedule.next();
            EXPECT_EQ(photons.before, pass * kMost);
            EXPECT_EQ(photons.paths, kMost);
            if (!learns || pass > 0) {
                EXPECT_EQ(photons.counted, double(kMost));
            }
            EXPECT_LE(photons.counted, double(kMost));
            EXPECT_GE(photons.counted, double(kMost) - 1e6);
            schedule.end_pass();
        }
    }
    EXPECT_EQ(learning_weight(kOne << 53), 1);
    EXPECT_EQ(learning_weight(~std::uint64_t{0}), 1);
    PartSwitch rest;
    rest.update(kOne << 53, false);
    EXPECT_FALSE(rest.enabled());
    rest.update((kOne << 54) - 1, true);
    EXPECT_FALSE(rest.enabled());
    rest.update(kOne << 54, true);
    EXPECT_TRUE(rest.enabled());
    record("passes of 2^32 - 1 photon paths, weights and rests past 2^53", "numbers exact");
}

/// The number asked for follows the noise however long the render.
TEST(StressCounters, TheScheduleGoesOnChoosing) {
    PhotonSchedule schedule(Settings(), 20000, true, false);
    PassPlanner planner(20000, 20000);
    const std::uint64_t passes = std::uint64_t(sized(1 << 14, 1 << 20));
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const auto paths = double(schedule.next().paths);
        const double photon_path = pass < passes / 64 ? 1e6 : 1e7;
        planner.add({.number = pass,
                     .work = {1e5, paths},
                     .photon_paths = schedule.next().paths,
                     .noise = {1 + photon_path / paths, photon_path}});
        schedule.end_pass();
        if (planner.plans_before(pass + 1))
            schedule.take(plan_passes(planner.take(pass + 1), schedule.limits()));
        ASSERT_GE(schedule.next().paths, 1u << 12);
        ASSERT_LE(schedule.next().paths, 1u << 22);
    }
    // sqrt(a B / (b A)), less what eye paths gain by being stratified, at most ten times the eye's
    // cost, in steps of a root of two.
    const double best = std::min(std::sqrt(1e5 * 1e7 / kStratifiedEye), 10 * 1e5);
    EXPECT_NEAR(double(schedule.next().paths) / best, 1, std::sqrt(2.0) - 1);
    record(std::to_string(passes) + " passes, the photons' noise ten times as large soon",
           std::to_string(schedule.next().paths) + " photon paths of " +
               std::to_string(std::llround(best)));
}

}  // namespace
}  // namespace photon_counters_test
