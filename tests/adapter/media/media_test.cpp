// Protects light in media: the absolute scale of what photons and shadow rays bring there, which of
// them owns what (docs/understand/media.md), that nothing else changes it, and that the bits are
// the same for any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "block_test.h"
#include "eye/volume_beam.h"
#include "render_mock.h"
#include "run_on_threads.h"
#include "test_form.h"

namespace aips::media_test {
namespace {

constexpr std::uint32_t kSize = 16;
/// Scatters each channel otherwise.
const mock::Fog kColoured{{0.05f, 0.1f, 0.3f}, {0.5f, 0.4f, 0.2f}, 0};

mock::Rendering render_along_y(const mock::Scene& scene, const Settings& settings,
                               std::uint32_t passes, float half_width = 0.5f) {
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, half_width, kSize, kSize);
    return mock::render(scene, camera, kSize, kSize, settings, passes);
}

/// A box whose walls emit 1 - `albedo` and reflect the rest, filled with fog.
mock::Scene furnace(float albedo) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.reflectance = {albedo, albedo, albedo};
    wall.emitted = {1 - albedo, 1 - albedo, 1 - albedo};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    return scene;
}

Settings fog_settings(std::uint64_t seed) {
    Settings settings = mock::small_settings(seed, 20000);
    settings.max_photon_depth = 32;
    settings.start_radius = 0.5;
    return settings;
}

/// Mean of an image.
Rgb mean_of(const mock::Film& film) {
    Rgb mean;
    for (const Rgb& pixel : film.image())
        mean += pixel / float(kSize * kSize);
    return mean;
}

/// Fog that absorbs nothing between walls that keep all light: the radiance is 1 everywhere,
/// whatever the fog scatters, and whoever carries the light. Each channel's mean within 4 standard
/// errors, of which one is below 3 % (long form: 2 %), and half a per cent for what beams lose at
/// the walls.
void expect_furnace(float albedo, const mock::Fog& fog, bool direct) {
    const unsigned seeds = statistics::sized(5u, 8u);
    mock::Scene scene = furnace(albedo);
    scene.fill(fog);
    double sums[3] = {}, squares[3] = {};
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Settings settings = fog_settings(seed);
        settings.direct_light_sampling = direct;
        // A beam as wide as it can be without touching the walls at its sides.
        settings.start_radius = 3;
        const auto r = render_along_y(scene, settings, 5, 0.25f);
        EXPECT_TRUE(r.statistics.refused.empty());
        const Rgb mean = mean_of(r.film);
        const float channels[] = {mean.r, mean.g, mean.b};
        for (int c = 0; c < 3; ++c) {
            sums[c] += channels[c] / double(seeds);
            squares[c] += double(channels[c]) * channels[c] / seeds;
        }
    }
    for (int c = 0; c < 3; ++c) {
        const double error = std::sqrt(std::max(squares[c] - sums[c] * sums[c], 0.0) / (seeds - 1));
        EXPECT_NEAR(sums[c], 1, 4 * error + 0.005) << "channel " << c;
        EXPECT_LT(error, statistics::sized(0.03, 0.02)) << "channel " << c;
    }
}

TEST(Media, WhiteFogIsInvisibleInAFurnace) {
    const mock::Fog grey{{}, {0.4f, 0.4f, 0.4f}, 0};
    const mock::Fog coloured{{}, {0.2f, 0.6f, 1.2f}, 0.6f};
    const mock::Fog backwards{{}, {0.4f, 0.4f, 0.4f}, -0.4f};
    for (const bool direct : {true, false}) {
        SCOPED_TRACE(direct);
        expect_furnace(0, grey, direct);
        expect_furnace(0.5f, coloured, direct);
        expect_furnace(0.5f, backwards, direct);
    }
}

/// A lamp box in fog that absorbs and scatters.
struct FoggyBox {
    FoggyBox() : scene(mock::lamp_box({}, mock::half_mirror())) { scene.fill(kColoured); }
    mock::Scene scene;
};

/// Block means of foggy boxes with different seeds.
statistics::BlockMeans renders(const Settings& asked_for, std::uint64_t first_seed) {
    const FoggyBox box;
    const unsigned seeds = statistics::sized(7u, 10u);
    statistics::BlockMeans means;
    for (unsigned s = 0; s < seeds; ++s) {
        Settings settings = asked_for;
        settings.seed = first_seed + s;
        const auto r = render_along_y(box.scene, settings, 6);
        means.push_back(statistics::block_means(mock::luminances(r.film), kSize, kSize, 8));
    }
    return means;
}

/// What all are compared with: nothing guided, progressive radii.
statistics::BlockMeans plain() {
    return renders(fog_settings(0), 1000);
}

void expect_same(const statistics::BlockMeans& first, const Settings& other) {
    const auto second = renders(other, 3000);
    const auto same = statistics::compare(first, second, 0.01);
    EXPECT_FALSE(same.differs()) << same.describe();
    const double planted = statistics::sized(0.1, 0.06);
    EXPECT_LT(same.detectable, planted / 1.5) << same.describe();
    const auto found = statistics::compare(first, statistics::scaled(second, 1 + planted), 0.01);
    EXPECT_TRUE(found.differs()) << "a planted bias went unnoticed: " << found.describe();
}

/// Light from the lamp to the fog belongs to shadow rays, or to photons without these.
TEST(Media, SingleScatteringBelongsToOneStrategy) {
    Settings photons = fog_settings(0);
    photons.direct_light_sampling = false;
    expect_same(plain(), photons);
}

TEST(Media, NarrowBeamsKeepTheExpectation) {
    Settings narrow = fog_settings(0);
    narrow.start_radius = 0.15;
    narrow.photons_per_pass = 60000;
    expect_same(plain(), narrow);
}

TEST(Media, GuidesKeepTheExpectation) {
    const auto unguided = plain();
    for (const GuideKind kind : {GuideKind::Paper, GuideKind::Adaptive}) {
        Settings guided = fog_settings(0);
        guided.guide = kind;
        expect_same(unguided, guided);
    }
}

TEST(Media, ModesKeepTheExpectation) {
    const auto progressive = plain();
    for (const Mode mode : {Mode::PhotonMap, Mode::Ppm}) {
        Settings frozen = fog_settings(0);
        frozen.mode = mode;
        frozen.hit_points_per_pass = 16 * kSize * kSize;
        expect_same(progressive, frozen);
    }
}

TEST(Media, SameBitsForAnyNumberOfThreads) {
    const FoggyBox box;
    for (const GuideKind kind : {GuideKind::None, GuideKind::Adaptive}) {
        Settings settings = fog_settings(7);
        settings.guide = kind;
        const auto image_with = [&](unsigned threads) {
            return concurrency::run_on(
                threads, [&] { return render_along_y(box.scene, settings, 3).film.image(); });
        };
        const auto one = image_with(1);
        EXPECT_EQ(one, image_with(2));
        EXPECT_EQ(one, image_with(7));
    }
}

TEST(Media, MemoryStaysWithinItsBound) {
    const FoggyBox box;
    const auto s = render_along_y(box.scene, fog_settings(3), 4).statistics;
    EXPECT_GT(s.gathered, 0u);
    EXPECT_LE(s.memory_bytes, s.memory_bound_bytes);
}

TEST(Media, ChainsAreLeftOutAloud) {
    const FoggyBox box;
    Settings settings = fog_settings(3);
    settings.photon_sampler = PhotonSampler::AdaptiveChains;
    const auto r = render_along_y(box.scene, settings, 1);
    EXPECT_TRUE(std::any_of(r.log.lines.begin(), r.log.lines.end(), [](const std::string& line) {
        return line.find("skipped photonsampler amc") != std::string::npos;
    }));
}

/// Mirrors alone, which take no photons: the fog still does, and the guide is left out.
TEST(Media, FogAloneTakesPhotons) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.kind = mock::Material::Kind::Mirror;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.add_point_light({0.2f, 0.4f, 0.3f}, {1, 1, 1});
    scene.finish();
    scene.fill(kColoured);
    Settings settings = fog_settings(5);
    settings.guide = GuideKind::Adaptive;
    settings.max_eye_depth = 32;
    const double rays = render_along_y(scene, settings, 60).film.mean();
    settings.direct_light_sampling = false;
    const double photons = render_along_y(scene, settings, 60).film.mean();
    EXPECT_GT(rays, 0);
    EXPECT_NEAR(photons / rays, 1, 0.03);
}

/// What distances on a segment are drawn by: their density, integrated to each drawn quantile.
TEST(Media, SegmentExponentialDrawsByItsDensity) {
    for (const float rate : {1e-9f, 0.3f, 20.0f}) {
        const SegmentExponential distances({rate, rate, rate}, {rate, rate, rate}, 2);
        for (int i = 1; i < 10; ++i) {
            const float t = distances.sample(float(i) / 10);
            constexpr int kSteps = 1000;
            double below = 0;
            for (int step = 0; step < kSteps; ++step)
                below += double(distances.pdf(t * (float(step) + 0.5f) / kSteps) * t / kSteps);
            EXPECT_NEAR(below, double(i) / 10, 1e-4) << rate;
        }
    }
}

}  // namespace
}  // namespace aips::media_test
