// Protects: what a scene doesn't need is not run, the log says so, and the image is the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "lamp_room.h"
#include "plan/needs.h"
#include "render_mock.h"
#include "scene_with_lights.h"

namespace aips::needs_test {
namespace {

std::ptrdiff_t times_logged(const mock::Log& log, const std::string& text) {
    return std::count_if(log.lines.begin(), log.lines.end(),
                         [&](const std::string& l) { return l.find(text) != std::string::npos; });
}

bool logged(const mock::Log& log, const std::string& text) {
    return times_logged(log, text) > 0;
}

mock::Rendering render_box(const Settings& settings) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 16, 12);
    return mock::render(scene, camera, 16, 12, settings, 2);
}

TEST(Needs, NoPhotonsWhenShadowRaysCarryAll) {
    Settings settings = mock::small_settings(61, 5000);
    settings.max_photon_depth = 1;
    const auto r = render_box(settings);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: shadow rays carry all light"));
    EXPECT_GT(r.film.mean(), 0);
}

TEST(Needs, NoGuideIsBuiltWithoutPhotonsToGuide) {
    for (const GuideKind guide : {GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = mock::small_settings(61, 5000);
        settings.max_photon_depth = 1;
        settings.guide = guide;
        const auto r = render_box(settings);
        EXPECT_EQ(r.statistics.guide_bytes, 0u) << mock::name(guide);
        EXPECT_TRUE(logged(r.log, "skipped guide: no photons to guide")) << mock::name(guide);
    }
}

TEST(Needs, NoPhotonsWithoutLight) {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    scene.finish();
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, 8, 8);
    const auto r = mock::render(scene, camera, 8, 8, mock::small_settings(62, 5000), 2);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: no light emits"));
    EXPECT_EQ(r.film.mean(), 0);
}

TEST(Needs, NoPhotonsWithoutReceivers) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.kind = mock::Material::Kind::Mirror;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, 8, 8);
    const auto r = mock::render(scene, camera, 8, 8, mock::small_settings(63, 5000), 1);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: no surface takes photons"));
}

/// A camera that sees no receiver shoots no photons either.
TEST(Needs, NoPhotonsWithoutVisiblePoints) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, 5, 0}, 0.1f, 8, 8);
    Settings settings = mock::small_settings(64, 5000);
    const auto r = mock::render(scene, camera, 8, 8, settings, 2);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_EQ(r.film.mean(), 0);
    EXPECT_EQ(times_logged(r.log, "skipped photons of a pass: no eye path met a surface"), 1);
    settings.mode = Mode::PhotonMap;
    const auto frozen = mock::render(scene, camera, 8, 8, settings, 2);
    EXPECT_EQ(times_logged(frozen.log, "skipped photon passes: no eye path met a surface"), 1);
}

/// A pass from within a glowing box without a diffuse surface.
auto render_glossy_box(const Settings& settings) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.kind = mock::Material::Kind::Phong;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    return mock::render(scene, mock::camera_along_y({0, 0, 0}, 1, 8, 8), 8, 8, settings, 1);
}

/// Without storeglossy glossy lobes bounce eye paths and take no photons.
TEST(Needs, PhotonsForGlossOnlyIfItTakesThem) {
    Settings settings = mock::small_settings(67, 5000);
    const auto bounced = render_glossy_box(settings);
    EXPECT_EQ(bounced.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(bounced.log, "skipped photon pass: no surface takes photons"));
    settings.store_glossy = true;
    EXPECT_EQ(render_glossy_box(settings).statistics.photon_paths, 5000u);
}

/// Neither what waits for photons nor what they would leave is held.
TEST(Needs, NoMemoryForPhotonsThatAreNotShot) {
    Settings settings = mock::small_settings(68, 5000);
    settings.radius = RadiusKind::Adaptive;
    const auto with = render_box(settings);
    settings.max_photon_depth = 1;
    const auto without = render_box(settings);
    // Film position and radiance of each eye path, and an arena.
    EXPECT_LE(without.statistics.memory_bytes, 16u * 12 * 20 + 2 * 16384);
    EXPECT_LE(without.statistics.memory_bytes, without.statistics.memory_bound_bytes);
    EXPECT_LT(4 * without.statistics.memory_bytes, with.statistics.memory_bytes);
    EXPECT_LT(1000 * without.statistics.memory_bound_bytes, with.statistics.memory_bound_bytes);
}

/// A light without power that must not be asked for anything.
class DeadLight final : public mock::LightLike {
  public:
    using LightLike::LightLike;
    float power() const override { return 0; }
    bool emit(const PrimaryPoint&, Emission&) const override {
        ADD_FAILURE() << "a photon from a dead light";
        return false;
    }
    bool sample_direct(const SurfacePoint&, Vec2, DirectSample&) const override {
        ADD_FAILURE() << "a shadow ray to a dead light";
        return false;
    }
};

TEST(Needs, DeadLightsAreNeverChosen) {
    const mock::Scene box = mock::lamp_box({}, {});
    const DeadLight dead(*box.lights()[0]);
    const mock::SceneWithLights scene(box, {box.lights()[0], &dead, &dead});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 16, 12);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = mock::small_settings(69, 20000);
        settings.guide = guide;
        const auto r = mock::render(scene, camera, 16, 12, settings, 3);
        EXPECT_GT(r.film.mean(), 0);
        EXPECT_TRUE(logged(r.log, "skipped 2 lights: no power")) << mock::name(guide);
    }
}

/// Where no photon bounces, nothing about bounces is learned.
TEST(Needs, NoPartsOfGuidesThatSteerNothing) {
    Settings settings = mock::small_settings(70, 20000);
    settings.direct_light_sampling = false;
    settings.guide = GuideKind::Adaptive;
    const auto bounced = render_box(settings);
    settings.max_photon_depth = 1;
    const auto landed = render_box(settings);
    const std::string reason = ": no photon goes on at this photon depth";
    EXPECT_TRUE(logged(landed.log, "skipped survival by score" + reason));
    EXPECT_TRUE(logged(landed.log, "skipped guided bounces" + reason));
    EXPECT_FALSE(logged(bounced.log, "skipped guided bounces"));
    EXPECT_LT(landed.statistics.guide_bytes + (1u << 20), bounced.statistics.guide_bytes);
    EXPECT_LT(landed.statistics.memory_bound_bytes, bounced.statistics.memory_bound_bytes);
    settings.guide = GuideKind::Paper;
    const auto paper = render_box(settings);
    EXPECT_TRUE(logged(paper.log, "skipped guide" + reason));
    EXPECT_EQ(paper.statistics.guide_bytes, 0u);
}

TEST(Needs, NoGuidedBouncesWithoutDiffuseSurfaces) {
    Settings settings = mock::small_settings(71, 5000);
    settings.store_glossy = true;
    settings.guide = GuideKind::Adaptive;
    const auto r = render_glossy_box(settings);
    EXPECT_TRUE(logged(r.log, "skipped guided bounces: no surface is diffuse"));
    EXPECT_GT(r.statistics.photon_paths, 0u);
}

/// A light that can't tell which numbers send a photon to a point.
class OneWayLight final : public mock::LightLike {
  public:
    using LightLike::LightLike;
    bool emission_coordinates(const SurfacePoint&, const DirectSample&,
                              PrimaryPoint&) const override {
        ++asked;
        return false;
    }
    mutable std::atomic<std::uint64_t> asked = 0;
};

TEST(Needs, NoSeedingFromTheEyeWhereNoLightAnswers) {
    const mock::Scene box = mock::lamp_box({}, {});
    const OneWayLight one_way(*box.lights()[0]);
    const mock::SceneWithLights scene(box, {&one_way});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 64, 64);
    Settings settings = mock::small_settings(72, 2000);
    settings.guide = GuideKind::Adaptive;
    settings.hit_points_per_pass = 1u << 17;
    const auto first = mock::render(scene, camera, 64, 64, settings, 1);
    const std::uint64_t in_first_pass = one_way.asked;
    EXPECT_GT(in_first_pass, 1000u);
    EXPECT_TRUE(logged(first.log, "skipped eye seeding from here on"));
    one_way.asked = 0;
    mock::render(scene, camera, 64, 64, settings, 3);
    EXPECT_EQ(one_way.asked, in_first_pass);
    const auto answered = mock::render(box, camera, 64, 64, settings, 1);
    EXPECT_FALSE(logged(answered.log, "skipped eye seeding"));
}

/// Direct photons are never stored under next-event estimation: with one bounce allowed, every
/// photon is at depth two.
TEST(Needs, DirectPhotonsAreDropped) {
    Settings settings = mock::small_settings(65, 5000);
    settings.max_photon_depth = 2;
    const auto with_rays = render_box(settings);
    EXPECT_TRUE(logged(with_rays.log, "skipped direct photons"));
    settings.direct_light_sampling = false;
    const auto alone = render_box(settings);
    EXPECT_GT(alone.statistics.photons, with_rays.statistics.photons);
}

TEST(Needs, UnguidedRunsHaveNoGuide) {
    const auto r = render_box(mock::small_settings(66, 5000));
    EXPECT_EQ(r.statistics.guide_bytes, 0u);
    EXPECT_EQ(r.statistics.guided_bounces, 0u);
    EXPECT_TRUE(logged(r.log, "skipped guide: not asked for"));
}

TEST(Needs, EyePathsGoOnWhereTheyShareLightWithPhotons) {
    const auto off = [](const std::string& reason, auto&& change) {
        Settings settings = mock::small_settings(67, 5000);
        change(settings);
        const auto r = render_box(settings);
        EXPECT_EQ(r.statistics.continued_paths, 0u);
        return logged(r.log, "skipped continued eye paths: " + reason);
    };
    EXPECT_GT(render_box(mock::small_settings(67, 5000)).statistics.continued_paths, 0u);
    EXPECT_FALSE(off("", [](Settings& s) { s.continue_eye_paths = false; })) << "as asked for";
    EXPECT_TRUE(off("no light to share", [](Settings& s) { s.max_photon_depth = 1; }));
    EXPECT_TRUE(off("no shadow rays", [](Settings& s) { s.direct_light_sampling = false; }));
    EXPECT_TRUE(off("eye paths belong", [](Settings& s) { s.mode = Mode::PhotonMap; }));
    EXPECT_TRUE(off("the paper's photons", [](Settings& s) { s.guide = GuideKind::Paper; }));
}

TEST(Needs, EdgesAreCorrectedWherePassesLookAnew) {
    const auto off = [](const std::string& reason, auto&& change) {
        Settings settings = mock::small_settings(69, 1000);
        change(settings);
        return logged(render_box(settings).log, "skipped correction of edges: " + reason);
    };
    EXPECT_FALSE(off("", [](Settings&) {}));
    EXPECT_FALSE(off("", [](Settings& s) { s.correct_edges = false; })) << "as asked for";
    EXPECT_TRUE(off("no photons", [](Settings& s) { s.max_photon_depth = 1; }));
    EXPECT_TRUE(off("the mode's", [](Settings& s) { s.mode = Mode::Ppm; }));
}

/// Nothing else asks what the inner halves of gather discs bring.
TEST(Needs, BlurNarrowsRadiiThatAdapt) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto narrows = [&](RadiusKind radius, std::uint32_t photon_depth, bool asked) {
        Settings settings = mock::small_settings(70, 1000);
        settings.radius = radius;
        settings.max_photon_depth = photon_depth;
        settings.narrow_radii = asked;
        const Needs needs = analyse(scene, settings);
        std::string why = "on";
        for (const std::string& skipped : needs.skipped)
            if (skipped.starts_with("radii that blur narrows: ")) why = skipped.substr(25);
        EXPECT_EQ(needs.settings.narrow_radii, why == "on" && asked);
        return why;
    };
    EXPECT_EQ(narrows(RadiusKind::Adaptive, 8, true), "on");
    EXPECT_EQ(narrows(RadiusKind::Adaptive, 8, false), "on") << "as asked for: nothing is skipped";
    EXPECT_EQ(narrows(RadiusKind::Schedule, 8, true), "radii do not adapt");
    EXPECT_EQ(narrows(RadiusKind::Adaptive, 1, true), "no photons to gather");
}

TEST(Needs, EmitterPathsAreDrawnWhereSpecularSurfacesShowEmitters) {
    const mock::View room = mock::lamp_room(16);
    const auto off = [&](const mock::View& view, const std::string& reason, auto&& change) {
        Settings settings = mock::small_settings(68, 1000);
        change(settings);
        const auto r = mock::render(view.scene, view.camera, 16, 16, settings, 2);
        EXPECT_EQ(r.statistics.emitter_searches, 0u);
        return logged(r.log, "skipped emitter paths: " + reason);
    };
    const auto on =
        mock::render(room.scene, room.camera, 16, 16, mock::small_settings(68, 1000), 2);
    EXPECT_GT(on.statistics.emitter_paths, 0u);
    EXPECT_FALSE(off(room, "", [](Settings& s) { s.guide_emitters = false; })) << "as asked for";
    EXPECT_TRUE(off(room, "eye paths belong", [](Settings& s) { s.mode = Mode::PhotonMap; }));
    EXPECT_TRUE(off(room, "the paper's", [](Settings& s) { s.guide = GuideKind::Paper; }));
    EXPECT_TRUE(off(room, "eye paths end", [](Settings& s) { s.max_eye_depth = 1; }));
    EXPECT_TRUE(off(room, "passes do not have", [](Settings& s) { s.hit_points_per_pass = 300; }));
    mock::View matte{mock::lamp_box({}, {}), mock::camera_along_y({0, -0.9f, 0}, 1, 16, 16)};
    EXPECT_TRUE(off(matte, "no surface is specular", [](Settings&) {}));
}

}  // namespace
}  // namespace aips::needs_test
