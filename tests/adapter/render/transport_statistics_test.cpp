// Protects transport statistics: they change no bit of the image, are the same for any number of
// threads, their counts add up, and the luminances that they tell by light add up to the image.
#include <gtest/gtest.h>

#include <numeric>

#include "lamp_room.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::transport_statistics_test {
namespace {

Settings settings_of(GuideKind guide, bool transport = true) {
    Settings settings = mock::small_settings(7, 20000);
    settings.guide = guide;
    settings.transport_statistics = transport;
    return settings;
}

/// A lamp, and a second one that is three times as strong and sealed in a black box.
mock::Rendering render_outshone(const Settings& settings, std::uint32_t passes = 4) {
    const mock::View view = mock::divided_view(40, 30, mock::sheet(true), 3);
    return mock::render(view.scene, view.camera, 40, 30, settings, passes);
}

void expect_same(const TransportStatistics& a, const TransportStatistics& b) {
    const auto counts = [](const TransportStatistics& transport) {
        std::vector<std::uint64_t> all{transport.eye_paths, transport.cut_eye_paths};
        for (const LightStatistics& t : transport.lights)
            all.insert(all.end(), {t.paths, t.counted});
        for (const MaterialStatistics& t : transport.materials)
            all.insert(all.end(), {t.hits, t.stored, t.unseen, t.direct, t.specular, t.black, t.cut,
                                   t.cut_specular});
        return all;
    };
    const auto luminances = [](const TransportStatistics& transport) {
        std::vector<double> all;
        for (const LightStatistics& t : transport.lights)
            all.insert(all.end(), {t.seen, t.photons});
        return all;
    };
    EXPECT_EQ(counts(a), counts(b));
    EXPECT_EQ(luminances(a), luminances(b));
    EXPECT_EQ(a.skipped, b.skipped);
}

class TransportStatisticsTest : public testing::TestWithParam<GuideKind> {};

TEST_P(TransportStatisticsTest, ChangesNoBitOfTheImage) {
    const auto with = render_outshone(settings_of(GetParam()));
    const auto without = render_outshone(settings_of(GetParam(), false));
    EXPECT_EQ(with.film.image(), without.film.image());
    EXPECT_EQ(with.statistics.photon_paths, without.statistics.photon_paths);
    EXPECT_TRUE(without.statistics.transport.lights.empty());
    EXPECT_TRUE(without.statistics.transport.materials.empty());
}

TEST_P(TransportStatisticsTest, IsTheSameForAnyNumberOfThreads) {
    const auto transport_on = [&](unsigned threads) {
        return concurrency::run_on(
            threads, [&] { return render_outshone(settings_of(GetParam())).statistics.transport; });
    };
    const TransportStatistics one = transport_on(1);
    expect_same(one, transport_on(2));
    expect_same(one, transport_on(7));
}

TEST_P(TransportStatisticsTest, AddsUp) {
    const EngineStatistics s = render_outshone(settings_of(GetParam())).statistics;
    ASSERT_EQ(s.transport.lights.size(), 2u);
    EXPECT_EQ(s.transport.lights[0].paths + s.transport.lights[1].paths, s.photon_paths);
    std::uint64_t hits = 0, stored = 0;
    for (const MaterialStatistics& t : s.transport.materials) {
        EXPECT_EQ(t.hits, t.stored + t.unseen + t.direct + t.specular + t.black);
        EXPECT_LE(t.cut_specular, t.cut);
        hits += t.hits;
        stored += t.stored;
    }
    EXPECT_GT(hits, s.photon_paths);
    EXPECT_EQ(stored, s.photons);
    EXPECT_EQ(s.transport.eye_paths, s.eye_paths);
}

TEST_P(TransportStatisticsTest, TellsThatASealedLampBringsNothing) {
    const TransportStatistics transport =
        render_outshone(settings_of(GetParam())).statistics.transport;
    ASSERT_EQ(transport.lights.size(), 2u);
    EXPECT_GT(transport.lights[0].counted, 0u);
    EXPECT_EQ(transport.lights[1].counted, 0u);
    EXPECT_EQ(transport.lights[1].seen + transport.lights[1].photons, 0);
}

/// By 64 passes with an eye path in each of 1200 pixels 2400 visible points tell: their mean is
/// within 5 % (two standard deviations are 3 %, by eight seeds).
TEST_P(TransportStatisticsTest, ItsLuminancesAreThoseOfTheImage) {
    const auto r = render_outshone(settings_of(GetParam()), 64);
    double told = 0;
    for (const LightStatistics& t : r.statistics.transport.lights)
        told += t.seen + t.photons;
    const auto luminances = mock::luminances(r.film);
    const double image =
        std::accumulate(luminances.begin(), luminances.end(), 0.0) / double(luminances.size());
    EXPECT_NEAR(told / image, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Guides, TransportStatisticsTest,
                         testing::Values(GuideKind::None, GuideKind::Paper, GuideKind::Adaptive),
                         [](const auto& test) { return mock::name(test.param); });

/// Lamps in glass and mirrors are met by eye paths and by emitter paths, whose splats are told too.
TEST(TransportStatisticsOfEmitterPaths, ItsLuminancesAreThoseOfTheImage) {
    const mock::View view = mock::lamp_room(32);
    const auto r = mock::render(view.scene, view.camera, 32, 32, settings_of(GuideKind::None), 16);
    ASSERT_GT(r.statistics.emitter_images, 0u);
    const auto luminances = mock::luminances(r.film);
    const double image =
        std::accumulate(luminances.begin(), luminances.end(), 0.0) / double(luminances.size());
    ASSERT_EQ(r.statistics.transport.lights.size(), 1u);
    const LightStatistics& lamp = r.statistics.transport.lights[0];
    EXPECT_NEAR((lamp.seen + lamp.photons) / image, 1, 0.05);
}

TEST(TransportStatisticsOfDepth, TellsWhatTheDepthLimitsCutWithinGlass) {
    const mock::View view = mock::lamp_room(32);
    const auto transport = [&](std::uint32_t eye, std::uint32_t photon) {
        Settings settings = settings_of(GuideKind::None);
        settings.max_eye_depth = eye;
        settings.max_photon_depth = photon;
        return mock::render(view.scene, view.camera, 32, 32, settings, 1).statistics.transport;
    };
    const auto cut_specular = [](const TransportStatistics& of) {
        return std::accumulate(
            of.materials.begin(), of.materials.end(), std::uint64_t{0},
            [](std::uint64_t sum, const MaterialStatistics& t) { return sum + t.cut_specular; });
    };
    const TransportStatistics shallow = transport(2, 2), deep = transport(16, 16);
    EXPECT_GT(shallow.cut_eye_paths, shallow.eye_paths / 20);
    EXPECT_LT(deep.cut_eye_paths, deep.eye_paths / 200);
    EXPECT_GT(cut_specular(shallow), 20u * cut_specular(deep) + 100u);
}

}  // namespace
}  // namespace aips::transport_statistics_test
