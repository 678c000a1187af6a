// The settings and sizes that a saved state depends on.
#include "render/same_render.h"

namespace aips {
namespace {

/// To be raised whenever the content of states changes.
constexpr std::uint32_t kStateVersion = 23;

void state_of_settings(StateArchive& archive, const Settings& s) {
    archive.same(s.mode, "mode");
    archive.same(s.guide, "guide");
    archive.same(s.photon_sampler, "photonsampler");
    archive.same(std::uint8_t(adapts_radius(s)), "radius");
    archive.same(s.error_criterion, "errorcriterion");
    archive.same(s.neighbours, "neighbours");
    archive.same(s.seed, "seed");
    for (const std::uint32_t count :
         {s.max_eye_depth, s.max_photon_depth, s.max_bounces, s.photons_per_pass,
          s.hit_points_per_pass, s.iteration_photons, s.initial_photons, s.node_photons,
          s.tree_depth, s.max_nodes, s.cdf_resolution})
        archive.same(count, "counts in its settings");
    for (const double share : {s.start_radius, s.alpha, s.guide_share, s.error_alpha})
        archive.same(share, "radii or shares in its settings");
    for (const bool on :
         {s.include_environment, s.direct_light_sampling, s.store_glossy, s.debug_layers,
          s.learn_lights, s.continue_eye_paths, s.photon_turns, s.guide_lamps, s.correct_edges,
          s.photon_occlusion, s.narrow_radii, s.guide_emission, s.eye_seeding, s.guide_bounces,
          s.guide_survival, s.guide_chains, s.guide_scout, s.present_errors, s.first_landings})
        archive.same(std::uint8_t(on), "switches in its settings");
}

}  // namespace

void state_of_identity(StateArchive& archive, const Host& host, const Settings& settings,
                       std::uint32_t eye_paths) {
    archive.same(kStateVersion, "version of the engine");
    // Before the settings, of which some are off in media.
    archive.same(std::uint8_t(host.scene.media() != nullptr), "media");
    state_of_settings(archive, settings);
    archive.same(host.film.width(), "image size");
    archive.same(host.film.height(), "image size");
    archive.same(eye_paths, "eye paths");
    archive.same(host.scene.light_groups(), "light groups");
    archive.same(std::uint64_t{host.scene.lights().size()}, "lights");
    archive.same(std::uint64_t{host.scene.material_names().size()}, "materials");
}

void state_of_version(StateArchive& archive) {
    std::uint32_t version = kStateVersion;
    archive.value(version);
    if (version != kStateVersion)
        throw StateError("it was learned by another version of the engine");
}

}  // namespace aips
