// Renders that go on in a new engine.
#include "resumable_render.h"

#include "lamp_room.h"
#include "random_scenes.h"

namespace mock {

using namespace aips;

namespace {

/// Two lights of different kinds, a dead one, and all lobes that guides treat apart.
View lit_view(const ResumableCase& what) {
    View view = half_mirror_view(what.width, what.height);
    view.scene.add_point_light({-0.5f + what.moved, 0.2f, 0.3f}, {0.4f, 0.3f, 0.1f});
    if (what.another_lamp) view.scene.add_point_light({0.1f, 0.2f, 0.3f}, {0.1f, 0.1f, 0.1f});
    view.scene.add_point_light({0.5f, 0.2f, 0.3f}, {0, 0, 0});
    view.scene.finish();
    if (what.fog) view.scene.fill({{0.05f, 0.1f, 0.3f}, {0.5f, 0.4f, 0.2f}, 0});
    return view;
}

/// Caustics of a point light and of a lamp on a glossy floor.
View glass_over_gloss(std::uint32_t width, std::uint32_t height) {
    View view{{},
              {{0, -1.5f, 2}, {0, 0.6f, -0.8f}, {0.5f, 0, 0}, {0, 0.3f, 0.225f}, width, height}};
    Surface floor;
    floor.shape = Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    floor.material.kind = Material::Kind::Sheet;
    floor.material.glossy = {0.4f, 0.4f, 0.4f};
    view.scene.add(floor);
    Surface glass;
    glass.shape = Ball{{0, 0, 0.8f}, 0.5f, false};
    glass.material.kind = Material::Kind::Glass;
    view.scene.add(glass);
    Surface lamp;
    lamp.shape = Quad{{0.5f, -0.5f, 2}, {0, 0.5f, 0}, {0.5f, 0, 0}};
    lamp.emitted = {3, 2, 1};
    view.scene.add(lamp);
    view.scene.add_point_light({-0.5f, 0.2f, 2}, {1, 1, 1});
    view.scene.finish();
    return view;
}

View view_of(const ResumableCase& what) {
    if (what.lamps) return lamp_room(what.width);
    if (what.gloss) return glass_over_gloss(what.width, what.height);
    if (what.open) return random_view(15, {true}, what.width, what.height);
    return what.wide ? wide_view(40, what.width, what.height) : lit_view(what);
}

std::string mode_name(Mode mode) {
    if (mode == Mode::Progressive) return "progressive";
    return mode == Mode::PhotonMap ? "photonmap" : "ppm";
}

Settings settings_of(GuideKind guide, Mode mode = Mode::Progressive) {
    Settings settings = small_settings(5, 20000);
    settings.alpha = 0.7;
    settings.guide = guide;
    settings.mode = mode;
    settings.transport_statistics = true;
    return settings;
}

void add_modes(std::vector<ResumableCase>& cases) {
    for (const Mode mode : {Mode::Progressive, Mode::PhotonMap, Mode::Ppm}) {
        for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive})
            cases.push_back({mode_name(mode) + "_" + name(guide), settings_of(guide, mode)});
        Settings chains = settings_of(GuideKind::None, mode);
        chains.photon_sampler = PhotonSampler::AdaptiveChains;
        cases.push_back({mode_name(mode) + "_amc", chains});
    }
}

void add_parts(std::vector<ResumableCase>& cases) {
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        Settings radii = settings_of(guide);
        radii.radius = RadiusKind::Adaptive;
        cases.push_back({"radii_" + name(guide), radii, false, 20});
        Settings layers = settings_of(guide);
        layers.debug_layers = true;
        cases.push_back({"layers_" + name(guide), layers});
        cases.push_back({"fog_" + name(guide), settings_of(guide), true, 4});
        // Long enough for the first choice of photons per pass, and for parts of a guide to rest.
        Settings automatic = settings_of(guide);
        automatic.photons_per_pass = 0;
        cases.push_back({"automatic_" + name(guide), automatic, false, 11, 12, 9});
    }
    // Long enough for passes without photons.
    Settings turns = settings_of(GuideKind::None);
    turns.photons_per_pass = 0;
    ResumableCase in_turns{"photon_turns", turns, false, 13, 48, 48};
    in_turns.open = true;
    cases.push_back(in_turns);
    cases.push_back({"fog_photonmap", settings_of(GuideKind::Adaptive, Mode::PhotonMap), true, 3});
    Settings plain = settings_of(GuideKind::Adaptive);
    plain.guide_survival = plain.guide_bounces = plain.guide_emission = false;
    cases.push_back({"measured", plain});
    Settings needless = settings_of(GuideKind::Adaptive);
    needless.pilot_pass = true;
    needless.photons_per_pass = 0;
    cases.push_back({"needless_guide", needless, false, 8});
    Settings scored = settings_of(GuideKind::Paper);
    scored.error_criterion = CriterionKind::Image;
    cases.push_back({"scored_paper", scored});
    Settings landed = settings_of(GuideKind::Paper);
    landed.present_errors = landed.direct_photons = false;
    cases.push_back({"paper_as_landed", landed});
    // Shadow rays enough for tables of the lights.
    Settings lights = settings_of(GuideKind::None);
    lights.photons_per_pass = 1000;
    cases.push_back({"lights", lights, false, 8, 64, 48});
    // Images of a lamp in mirror and glass.
    ResumableCase lamps{"emitter_paths", settings_of(GuideKind::None)};
    lamps.settings.photons_per_pass = 1000;
    lamps.height = lamps.width;
    lamps.lamps = true;
    cases.push_back(lamps);
    ResumableCase gloss{"caustics_on_gloss", settings_of(GuideKind::Adaptive), false, 9};
    gloss.gloss = true;
    cases.push_back(gloss);
    // Next to nothing is seen.
    Settings explored = settings_of(GuideKind::Adaptive);
    explored.pilot_pass = true;
    explored.photons_per_pass = 200'000;
    explored.direct_light_sampling = false;
    cases.push_back({"explored", explored, false, 4, 20, 15, true});
    // So many paths that the guide learns from an iteration while the next is traced.
    Settings lagging = settings_of(GuideKind::Adaptive);
    lagging.photons_per_pass = 600'000;
    cases.push_back({"lagging_guide", lagging, false, 3});
}

}  // namespace

ResumableRender::ResumableRender(const ResumableCase& what, Ranks* ranks)
    : view_(view_of(what)),
      sampler_(what.settings.seed),
      film_(what.width, what.height, view_.scene.light_groups()),
      engine_(std::make_unique<Engine>(
          Host{view_.scene, view_.camera, sampler_, film_, log_, ranks}, what.settings)) {}

ResumableRender::ResumableRender(const ResumableCase& what, std::span<const std::byte> state,
                                 const Film& film, Ranks* ranks)
    : ResumableRender(what, ranks) {
    Restoring archive(state);
    engine_->state(archive);
    film_ = film;
    if (archive.remaining() > 0) throw StateError("more was saved than was restored");
}

Bytes ResumableRender::save() {
    Saving archive;
    engine_->state(archive);
    return archive.saved();
}

Bytes ResumableRender::save_learned() {
    Saving archive;
    engine_->learned(archive);
    return archive.saved();
}

void ResumableRender::take_learned(std::span<const std::byte> learned) {
    Restoring archive(learned);
    engine_->learned(archive);
    if (archive.remaining() > 0) throw StateError("more was learned than was taken");
}

std::vector<ResumableCase> resumable_cases() {
    std::vector<ResumableCase> cases;
    add_modes(cases);
    add_parts(cases);
    return cases;
}

}  // namespace mock
