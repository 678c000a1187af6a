// Protects the energy of renders at the ends of albedos and powers: closed forms with the cut-off
// by depth, lamps of hardly any size, thousands of lamps, lamps that outshine others a billion
// times and reach nothing, and no light at all. Nothing is refused, time and memory stay within
// bounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "block_test.h"
#include "stress_case.h"
#include "ways.h"

namespace aips::energy_test {
namespace {

constexpr double kSignificance = 0.01;

std::string percent(double share) {
    return std::to_string(100 * share) + " %";
}

/// What holds of every render: no refusals, no NaN, bounded memory, rays bounded by paths.
void expect_sane(const mock::Rendering& r, const Settings& settings, const std::string& what) {
    EXPECT_TRUE(r.statistics.refused.empty()) << what;
    EXPECT_LE(r.statistics.memory_bytes, r.statistics.memory_bound_bytes) << what;
    // A path may split into 17 photons; an adaptive guide walks from visible points as well.
    const DepthLimit depth = photon_depth(settings);
    EXPECT_LE(r.statistics.photon_rays, 17 * (r.statistics.photon_paths + r.statistics.eye_paths) *
                                            (depth.surfaces + depth.specular))
        << what;
    for (const Rgb& pixel : r.film.image()) {
        EXPECT_TRUE(std::isfinite(luminance(pixel)) && pixel.r >= 0 && pixel.g >= 0 && pixel.b >= 0)
            << what;
    }
}

/// Within a closed ball of constant albedo and emission the radiance is the geometric sum over the
/// scatterings allowed. A chord's disc has the area of the cap around it: density estimation has no
/// bias there.
TEST(StressEnergy, ClosedBallOfAnyAlbedo) {
    constexpr std::uint32_t kSize = 8;
    const unsigned seeds = stress::sized(6u, 20u);
    double worst = 0, tests = 3.0 * 3 * 2;
    const double threshold = 1 - std::pow(1 - kSignificance, 1 / tests);
    for (const float albedo : {0.0f, 0.999999f, 1.0f}) {
        mock::Scene scene;
        mock::Surface shell;
        shell.shape = mock::Ball{{0, 0, 0}, 1, true};
        shell.material.reflectance = {albedo, albedo, albedo};
        shell.emitted = {1, 1, 1};
        scene.add(shell);
        scene.finish();
        const auto camera = mock::camera_along_y({0, -0.3f, 0}, 1, kSize, kSize);
        for (const unsigned depth : {8u, 300u}) {
            double expected = 0;
            for (unsigned k = 0; k <= depth; ++k)
                expected += std::pow(double(albedo), k);
            const int photons = depth > 8 ? stress::sized(250, 500) : stress::sized(2000, 4000);
            for (const stress::Way& way : stress::ways(0, photons, false)) {
                statistics::BlockMeans means;
                Settings settings = way.settings;
                settings.max_photon_depth = depth;
                settings.start_radius = 1;
                for (unsigned seed = 0; seed < seeds; ++seed) {
                    settings.seed = 100 + seed;
                    const auto r = mock::render(scene, camera, kSize, kSize, settings, 3);
                    expect_sane(r, settings, way.name);
                    means.push_back({r.film.mean() / expected});
                }
                double mean = 0, variance = 0;
                for (const auto& value : means)
                    mean += value[0] / seeds;
                for (const auto& value : means)
                    variance += (value[0] - mean) * (value[0] - mean) / (seeds - 1) / seeds;
                const double error = std::sqrt(variance), off = std::abs(mean - 1);
                // Shadow rays alone are exact where nothing scatters twice.
                EXPECT_TRUE(off < 1e-5 || statistics::student_p(off / error, seeds - 1) > threshold)
                    << way.name << ", albedo " << albedo << ", depth " << depth << ": " << mean
                    << " +- " << error;
                EXPECT_LT(error, stress::sized(0.07, 0.05))
                    << way.name << ", albedo " << albedo << ", depth " << depth;
                worst = std::max(worst, off);
            }
        }
    }
    stress::record("albedo 0, 0.999999 and 1 in a closed ball, depth 8 and 300, three guides",
                   "closed form but for " + percent(worst) + ", within noise");
}

/// A room with whatever lamps `light` adds, seen from its front.
mock::View lit_room(const std::function<void(mock::Scene&)>& light) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.reflectance = {0.6f, 0.6f, 0.6f};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    light(scene);
    scene.finish();
    return {std::move(scene), mock::camera_along_y({0, -0.95f, 0}, 1, 12, 12)};
}

/// Four blocks of each of `seeds` renders.
statistics::BlockMeans blocks(const mock::View& view, stress::Way way, std::uint64_t first_seed,
                              unsigned seeds, std::uint64_t passes = 4) {
    statistics::BlockMeans means;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        way.settings.seed = first_seed + seed;
        const auto r = mock::render(view.scene, view.camera, 12, 12, way.settings, passes);
        expect_sane(r, way.settings, way.name);
        means.push_back(statistics::block_means(mock::luminances(r.film), 12, 12, 6));
    }
    return means;
}

/// The largest detectable difference of the mean, over the guides.
double expect_same_light(const mock::View& a, const mock::View& b) {
    double detectable = 0;
    const unsigned seeds = stress::sized(11u, 32u);
    for (const stress::Way& way : stress::ways(0, 3000, false)) {
        const auto c = statistics::compare(blocks(a, way, 1000, seeds), blocks(b, way, 2000, seeds),
                                           kSignificance / 3);
        EXPECT_FALSE(c.differs()) << way.name << ": " << c.describe();
        EXPECT_LT(c.detectable, stress::sized(0.15, 0.1)) << way.name << ": " << c.describe();
        detectable = std::max(detectable, c.detectable);
    }
    return detectable;
}

/// Behind the camera: an eye path that met the larger lamp would outshine all others.
mock::Surface ceiling_lamp(float edge) {
    mock::Surface lamp;
    lamp.shape = mock::Quad{{0.2f, -0.97f, 0.9f}, {0, edge, 0}, {edge, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = Rgb{1, 1, 1} / (edge * edge);
    return lamp;
}

TEST(StressEnergy, LampOfHardlyAnyArea) {
    const auto small = lit_room([](mock::Scene& s) { s.add(ceiling_lamp(1e-2f)); });
    const auto tiny = lit_room([](mock::Scene& s) { s.add(ceiling_lamp(1e-6f)); });
    stress::record("a lamp of area 1e-12 against one of 1e-4, the same power",
                   "same; detectable " + percent(expect_same_light(small, tiny)) + " of 10 %");
}

TEST(StressEnergy, TenThousandEqualLights) {
    const Vec3 place{0.2f, 0.1f, 0.5f};
    const auto one = lit_room([&](mock::Scene& s) { s.add_point_light(place, {1, 1, 1}); });
    const auto many = lit_room([&](mock::Scene& s) {
        for (int i = 0; i < 10000; ++i)
            s.add_point_light(place, {1e-4f, 1e-4f, 1e-4f});
    });
    stress::record("10,000 equal lights against their sum",
                   "same; detectable " + percent(expect_same_light(one, many)) + " of 10 %");
}

/// A guide that learns from a photon at a time, and variances of one.
TEST(StressEnergy, OnePhotonAPass) {
    const auto view = lit_room([](mock::Scene& s) {
        s.add_point_light({0.2f, 0.1f, 0.5f}, {1, 1, 1});
    });
    const unsigned seeds = stress::sized(8u, 24u);
    const std::uint64_t passes = stress::sized(1000, 6000);
    auto ones = stress::ways(0, 1, false), many = stress::ways(0, 3000, false);
    // Eye paths would carry nearly all beside one photon, without the bias of these wide radii.
    for (auto* ways : {&ones, &many}) {
        for (stress::Way& way : *ways)
            way.settings.continue_eye_paths = false;
    }
    double detectable = 0;
    for (std::size_t i = 0; i < ones.size(); ++i) {
        const auto c =
            statistics::compare(blocks(view, many[i], 1000, seeds),
                                blocks(view, ones[i], 2000, seeds, passes), kSignificance / 3);
        EXPECT_FALSE(c.differs()) << ones[i].name << ": " << c.describe();
        EXPECT_LT(c.detectable, 0.25) << ones[i].name << ": " << c.describe();
        detectable = std::max(detectable, c.detectable);
    }
    stress::record(std::to_string(passes) + " passes of one photon path against 4 of 3000",
                   "same; detectable " + percent(detectable) + " of 25 %");
}

/// 9,999 lights that are a billionth of the one that matters each.
TEST(StressEnergy, OneLightInTenThousandMatters) {
    const Vec3 place{0.2f, 0.1f, 0.5f};
    const auto one = lit_room([&](mock::Scene& s) { s.add_point_light(place, {1, 1, 1}); });
    const auto among = lit_room([&](mock::Scene& s) {
        for (int i = 0; i < 10000; ++i) {
            const float share = i == 7000 ? 1 : 1e-9f;
            s.add_point_light(i == 7000 ? place : Vec3{-0.5f, 0.5f, -0.5f}, Rgb{1, 1, 1} * share);
        }
    });
    stress::record("one light among 9,999 of a billionth of its power",
                   "same; detectable " + percent(expect_same_light(one, among)) + " of 10 %");
}

/// Lights sealed in a black ball reach nothing; what they outshine lights the room. Nobody but a
/// guide finds that light a billion times weaker, and shadow rays can't: photons carry all.
TEST(StressEnergy, LightOutshoneBySealedOnes) {
    const auto seal = [](mock::Scene& s) {
        mock::Surface ball;
        ball.shape = mock::Ball{{-0.5f, 0.5f, -0.5f}, 0.1f, true};
        ball.material.reflectance = {0, 0, 0};
        s.add(ball);
    };
    const Vec3 place{0.2f, 0.1f, 0.5f};
    const auto alone = lit_room([&](mock::Scene& s) {
        seal(s);
        s.add_point_light(place, {1, 1, 1});
    });
    const auto with = [&](int sealed, float strength) {
        return lit_room([&](mock::Scene& s) {
            seal(s);
            for (int i = 0; i < sealed; ++i)
                s.add_point_light({-0.5f, 0.5f, -0.5f}, Rgb{1, 1, 1} * strength);
            s.add_point_light(place, {1, 1, 1});
        });
    };
    stress::Way way = stress::ways(0, 20000, false)[2];
    way.settings.direct_light_sampling = false;
    const unsigned seeds = stress::sized(6u, 24u);
    const auto expected = blocks(alone, way, 1000, seeds);
    for (const auto& [sealed, strength] : {std::pair(1, 1e9f), std::pair(9999, 1.0f)}) {
        const auto c = statistics::compare(
            expected, blocks(with(sealed, strength), way, 2000, seeds), kSignificance);
        EXPECT_FALSE(c.differs()) << sealed << ": " << c.describe();
        stress::record(std::to_string(sealed) + " sealed light(s) of " + std::to_string(strength),
                       c.describe());
    }
}

TEST(StressEnergy, BlackScenesEnd) {
    const auto no_light = lit_room([](mock::Scene&) {});
    const auto dead = lit_room([](mock::Scene& s) { s.add_point_light({0, 0, 0}, {0, 0, 0}); });
    mock::Scene black;
    mock::Surface wall;
    wall.material.reflectance = {0, 0, 0};
    black.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    black.add_point_light({0.2f, 0.1f, 0.5f}, {1, 1, 1});
    black.finish();
    const mock::Scene* const scenes[] = {&no_light.scene, &dead.scene, &black};
    for (const mock::Scene* scene : scenes) {
        for (const stress::Way& way : stress::ways(1, 1000, true)) {
            const auto r = mock::render(*scene, no_light.camera, 12, 12, way.settings, 3);
            expect_sane(r, way.settings, way.name);
            EXPECT_EQ(r.film.mean(), 0) << way.name;
        }
    }
    stress::record("no light, a dead light, black walls; nine ways", "black images, no refusal");
}

}  // namespace
}  // namespace aips::energy_test
