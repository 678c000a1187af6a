// Protects eye seeding: seeds lead photons to what the eye sees, weigh what the light is worth
// there, and do not depend on threads.
#include <gtest/gtest.h>

#include "aips/core/sampling/sampling.h"
#include "eye/light_choice.h"
#include "eye/traced_eye_image.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/eye_seeding.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::eye_seeding_test {
namespace {

constexpr std::uint32_t kSize = 64, kEyePaths = kSize * kSize;

std::vector<EmissionSeed> find(const mock::Scene& scene, const Settings& settings,
                               const EyeImage& image, std::uint64_t pass = 0) {
    std::vector<EmissionSeed> seeds;
    SeedCounts counts;
    find_emission_seeds(scene, settings, light_choice(scene), pass, 0, image, seeds, counts);
    EXPECT_EQ(counts.walks, (image.visible_points.size() + kSeedGroup - 1) / kSeedGroup);
    EXPECT_GE(counts.rays, seeds.size());
    EXPECT_LE(seeds.size(), counts.walks * kMaxSeedsPerWalk);
    return seeds;
}

/// A pillar on a ground that is a hundred times as wide as the view, under a sun.
mock::Scene wide_ground(float half_width = 100) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape =
        mock::Quad{{-half_width, -half_width, 0}, {2 * half_width, 0, 0}, {0, 2 * half_width, 0}};
    scene.add(ground);
    mock::Surface pillar;
    scene.add_box({0.5f, 0.5f, 2}, {-0.5f, -0.5f, 0}, pillar);  // inside out: faces look outwards
    scene.add_distant_light({normalize({1, 0.5f, 1}), 0.9999f}, {1000, 1000, 1000});
    scene.finish();
    return scene;
}

mock::Camera view_from_above() {
    return {{0, 0, 4}, {0, 0, -1}, {0.25f, 0, 0}, {0, 0.25f, 0}, 64, 64};
}

mock::Camera view_beside_the_pillar() {
    return {{1.5f, 0, 4}, {0, 0, -1}, {0.25f, 0, 0}, {0, 0.25f, 0}, 64, 64};
}

/// Share of photons whose first photon is within 4 of the pillar.
double share_near_view(const mock::Scene& scene, const std::vector<PrimaryPoint>& starts) {
    int near = 0;
    Arena arena;
    for (const PrimaryPoint& u : starts) {
        Emission emission;
        SurfacePoint hit;
        arena.reset();
        if (!scene.lights()[0]->emit(u, emission) || !scene.intersect(emission.ray, hit, arena))
            continue;
        near += length(hit.position) < 4 ? 1 : 0;
    }
    return near / double(starts.size());
}

TEST(EyeSeeding, SunOverAWideGroundIsSeededWhereTheEyeLooks) {
    const mock::Scene scene = wide_ground();
    const Settings settings = mock::small_settings(1, 1);
    const EyeImage image =
        mock::traced_eye_image(scene, view_beside_the_pillar(), kSize, kEyePaths, settings);
    const auto seeds = find(scene, settings, image);
    ASSERT_GT(seeds.size(), 10u);
    std::vector<PrimaryPoint> guided, plain;
    for (const EmissionSeed& s : seeds) {
        EXPECT_EQ(s.light, 0u);
        EXPECT_TRUE(s.weight > 0 && std::isfinite(s.weight));
        guided.push_back(s.point);
    }
    RandomStream random(79, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 20000; ++i)
        plain.push_back({random.next(), random.next(), random.next(), random.next()});
    EXPECT_LT(share_near_view(scene, plain), 0.01);
    EXPECT_EQ(share_near_view(scene, guided), 1.0);
}

/// Four thousand times as wide: one start in ten millions is near the view. The seeds of one pass
/// lead the guide there, without any photon having been there.
TEST(EyeSeeding, SeedsOfOnePassLeadToATenMillionthOfAllStarts) {
    const mock::Scene scene = wide_ground(4000);
    const Settings settings = mock::small_settings(1, 1);
    const EyeImage image =
        mock::traced_eye_image(scene, view_beside_the_pillar(), kSize, kEyePaths, settings);
    const DiscreteDistribution choice = light_choice(scene);
    EmissionGuide guide(1, choice);
    guide.add_seeds(find(scene, settings, image));
    guide.update(0);
    std::vector<PrimaryPoint> starts;
    RandomStream random(80, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 20000; ++i) {
        const PrimaryPoint u{random.next(), random.next(), random.next(), random.next()};
        starts.push_back(guide.sample(0.5f, u).point);
    }
    EXPECT_GT(share_near_view(scene, starts), 0.5 * EmissionGuideSettings{}.seed_share);
}

/// From a pillar's flat top alone nothing but sky is met; photons that own direct light, however,
/// must come to the top itself.
TEST(EyeSeeding, DirectLightIsSeededWherePhotonsOwnIt) {
    const mock::Scene scene = wide_ground();
    Settings settings = mock::small_settings(2, 1);
    mock::Camera above = view_from_above();
    EyeImage image = mock::traced_eye_image(scene, above, kSize, kEyePaths, settings);
    std::erase_if(image.visible_points, [](const VisiblePoint& v) { return v.position.z < 1; });
    ASSERT_GT(image.visible_points.size(), 1000u);
    EXPECT_TRUE(find(scene, settings, image).empty());
    settings.direct_light_sampling = false;
    const auto seeds = find(scene, settings, image);
    EXPECT_EQ(seeds.size(), (image.visible_points.size() + kSeedGroup - 1) / kSeedGroup);
}

/// In a hollow ball with a point light and a screen before it, a photon that starts at a seed meets
/// the surface that the walk met; the weight is throughput * kd * albedo / pi * I cos / d^2 there.
TEST(EyeSeeding, WeightIsTheLightThatReachesTheEyePath) {
    constexpr float kIntensity = 5;
    const Vec3 lamp{0, 0, 1};
    mock::Scene scene;
    mock::Surface shell, screen;
    shell.shape = mock::Ball{{0, 0, 0}, 2, true};
    shell.material.reflectance = {0.6f, 0.6f, 0.6f};
    screen.shape = mock::Quad{{-0.5f, -0.5f, -0.5f}, {1, 0, 0}, {0, 1, 0}};
    scene.add(shell);
    scene.add(screen);
    scene.add_point_light(lamp, kWhite * kIntensity);
    scene.finish();
    EyeImage image;
    VisiblePoint v;
    v.position = {0, 0, -2};
    v.geometric_normal = v.shading_normal = v.wo = {0, 0, 1};
    v.throughput = kWhite * 0.5f;
    v.kd = kWhite * 0.3f;
    v.receiving = kDiffuse;
    image.visible_points.assign(16000, v);
    const auto seeds = find(scene, mock::small_settings(3, 1), image);
    EXPECT_GT(seeds.size(), 500u);  // of 1000 walks; the screen shades the rest
    for (const EmissionSeed& s : seeds) {
        Arena arena;
        Emission emission;
        SurfacePoint hit;
        ASSERT_TRUE(scene.lights()[0]->emit(s.point, emission));
        ASSERT_TRUE(scene.intersect(emission.ray, hit, arena));
        EXPECT_EQ(hit.material, 0u) << "on the screen";
        const float cosine = -dot(hit.geometric_normal, emission.ray.direction);
        const float d2 = length_squared(hit.position - lamp);
        const float expected = 0.5f * 0.3f * 0.6f / kPi * kIntensity * cosine / d2;
        EXPECT_NEAR(s.weight, expected, 2e-3f * expected);
    }
}

/// A lamp seen from the floor in a mirror overhead: light met after a specular bounce names the
/// very photon that returns along the walk.
TEST(EyeSeeding, LampsSeenInMirrorsAreSeededExactly) {
    mock::Scene scene;
    mock::Surface mirror, lamp;
    mirror.shape = mock::Quad{{-5, -5, 2}, {0, 10, 0}, {10, 0, 0}};
    mirror.material.kind = mock::Material::Kind::Mirror;
    mirror.material.reflectance = {0.9f, 0.9f, 0.9f};
    lamp.shape = mock::Quad{{1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    lamp.emitted = {3, 3, 3};
    scene.add(mirror);
    scene.add(lamp);
    scene.finish();
    EyeImage image;
    VisiblePoint v;
    v.geometric_normal = v.shading_normal = v.wo = {0, 0, 1};
    v.throughput = v.kd = kWhite;
    v.receiving = kDiffuse;
    image.visible_points.assign(16000, v);
    const auto seeds = find(scene, mock::small_settings(4, 1), image);
    int returning = 0;
    for (const EmissionSeed& s : seeds) {
        Emission emission;
        ASSERT_TRUE(scene.lights()[0]->emit(s.point, emission));
        // Where the photon comes down from the mirror at z = 2.
        const Vec3 o = emission.ray.origin, d = emission.ray.direction;
        const Vec3 down = o + d * ((4 - o.z) / d.z);
        if (std::hypot(down.x, down.y) > 1e-2f) continue;
        ++returning;
        EXPECT_NEAR(s.weight, 0.9f * 3, 1e-4f);
    }
    EXPECT_GT(returning, 25);  // the lamp fills 5 % of the hemisphere of 1000 walks
}

TEST(EyeSeeding, BitsDoNotDependOnThreads) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings = mock::small_settings(5, 1);
    const mock::Camera camera = mock::camera_along_y({0, -0.9f, 0}, 0.5f, 64, 64);
    const EyeImage image = mock::traced_eye_image(scene, camera, kSize, kEyePaths, settings);
    const auto found_with = [&](unsigned threads, std::uint64_t pass) {
        return concurrency::run_on(threads, [&] { return find(scene, settings, image, pass); });
    };
    const auto same = [](const EmissionSeed& a, const EmissionSeed& b) {
        return a.light == b.light && a.point == b.point && a.weight == b.weight;
    };
    const auto one = found_with(1, 0), four = found_with(4, 0), next = found_with(4, 1);
    ASSERT_GT(one.size(), 100u);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), four.begin(), four.end(), same));
    EXPECT_FALSE(std::equal(one.begin(), one.end(), next.begin(), next.end(), same));
}

}  // namespace
}  // namespace aips::eye_seeding_test
