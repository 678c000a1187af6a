// Bound of the engine's memory.
#include "plan/memory_bound.h"

#include <tbb/task_arena.h>

#include "base/vector_growth.h"
#include "contribution/iteration_scores.h"
#include "contribution/own_light_noise.h"
#include "contribution/pass_noise.h"
#include "contribution/path_contribution.h"
#include "contribution/photon_square.h"
#include "estimate/constants.h"
#include "estimate/edge_correction.h"
#include "eye/eye_pass.h"
#include "guides/adaptive/adaptive_guide.h"
#include "guides/paper/paper_guide.h"
#include "photons/exploration.h"
#include "photons/photon_chains.h"
#include "photons/photon_pass.h"
#include "radii/adaptive_radius.h"
#include "radii/ppm_radius.h"
#include "radii/scheduled_radius.h"

namespace aips {
namespace {

/// What an eye pass leaves but for its visible points. Each block's arena holds a chunk, and a
/// second one where a Bsdf did not fit.
std::size_t eye_image_bytes(const Scene& scene, std::size_t paths) {
    // Radiance, and what continued paths brought; what is left to emitter paths, twice while
    // joined.
    const std::size_t image = sizeof(Vec2) + 2 * std::size_t{scene.light_groups()} * sizeof(Rgb) +
                              2 * kVectorGrowth * sizeof(EmitterRest);
    const std::size_t arenas = Arena::kChunkBytes / 512;
    const std::size_t last_block = 2 * Arena::kChunkBytes + scene.facts().max_bsdf_bytes;
    return paths * (image + arenas) + last_block;
}

/// What photon paths are traced in: each thread has an arena for one Bsdf at a time, with a second
/// chunk where that does not fit, and while chains walk, another.
std::size_t thread_bytes(const Scene& scene) {
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    return threads * 2 * (2 * Arena::kChunkBytes + scene.facts().max_bsdf_bytes);
}

/// What shadow rays tell, in blocks and joined, and what is learned from it.
std::size_t light_bytes(const Settings& s, const Scene& scene, std::uint32_t eye_paths) {
    if (!s.learn_lights) return 0;
    const std::size_t samples = light_samples_due(eye_paths);
    return 2 * samples * kVectorGrowth * sizeof(LightSample) +
           DirectLight::memory_bound_bytes(scene, samples);
}

/// Visible points, their Bsdfs, and what is estimated there.
std::size_t visible_point_bytes(const Scene& scene, std::size_t paths) {
    const std::size_t groups = scene.light_groups();
    // Flux, its photons and squares, radiance, and that as it counts.
    const std::size_t estimate = 3 * groups * sizeof(Rgb) + sizeof(std::uint32_t) + sizeof(float);
    const std::size_t shareable = sizeof(ShareableFlux);
    // While blocks are joined, their visible points exist twice.
    const std::size_t transient = kVectorGrowth * sizeof(VisiblePoint);
    const std::size_t footprints = 2 * kVectorGrowth * sizeof(float);
    return paths * (sizeof(VisiblePoint) + sizeof(Vec3) + scene.facts().max_bsdf_bytes + estimate +
                    shareable + transient + footprints);
}

/// Most photons of an iteration: those of guides may be split, those without one are longer.
std::size_t iteration_photons(const Settings& s) {
    if (s.guide == GuideKind::Paper)
        return most_photons(s, std::max(s.iteration_photons, s.initial_photons));
    const std::size_t guided =
        s.guide == GuideKind::Adaptive ? most_photons(s, kIterationPaths) : 0;
    return std::max(guided, std::size_t{kPlainIterationPaths} * most_photons_per_path(s));
}

/// Of chains that photon paths come from, or that explore.
std::size_t chain_bytes(const Scene& scene, const Settings& s, std::uint32_t eye_paths) {
    if (may_explore(s)) return exploration_memory_bound(scene, s, eye_paths);
    return may_use_chains(s) ? PhotonChains::memory_bound_bytes(s, eye_paths) : 0;
}

/// Photons of the store that waits, of one iteration in blocks, with guide=paper once more joined,
/// and the grid.
std::size_t photon_bytes(const Scene& scene, const Settings& s, std::uint32_t eye_paths) {
    const std::size_t iteration = iteration_photons(s);
    const std::size_t waiting = kWaitingPhotons + iteration;
    const std::size_t apart = s.guide == GuideKind::Paper ? 2 * iteration : iteration;
    return (waiting + apart) * kVectorGrowth * sizeof(Photon) +
           PhotonGrid::memory_bound_bytes(waiting) + chain_bytes(scene, s, eye_paths);
}

/// Records of an iteration's paths in blocks, joined ones of it and of the one before, and scores
/// of their photons. At most all paths are logged.
std::size_t log_bytes(const Settings& s, std::size_t paths) {
    const std::size_t path = sizeof(PathRecord) + most_surfaces(s) * sizeof(PathVertex);
    // Of the first photon of each path.
    const std::size_t photons = most_photons_per_path(s) * (2 * sizeof(Photon) + sizeof(double));
    return paths * kVectorGrowth * (3 * path + photons) +
           PathContributions::memory_bound_bytes(paths, most_surfaces(s));
}

/// Beams, which exist twice while blocks are joined, and what photons bring to them.
std::size_t volume_bytes(const Scene& scene, const Settings& s, std::size_t eye_paths) {
    if (!scene.media()) return 0;
    const std::size_t iteration = iteration_photons(s);
    return eye_paths * 2 * kVectorGrowth * sizeof(VolumeBeam) +
           VolumeGather::memory_bound_bytes(scene, eye_paths, iteration);
}

}  // namespace

std::size_t eye_memory_bound(const Scene& scene, const Settings& settings,
                             std::uint32_t eye_paths) {
    return eye_image_bytes(scene, eye_paths) + light_bytes(settings, scene, eye_paths);
}

std::size_t photon_memory_bound(const Scene& scene, const Needs& needs, std::uint32_t eye_paths,
                                std::size_t pixels) {
    if (!needs.photons) return 0;
    const Settings& settings = needs.settings;
    const auto points = std::uint32_t(most_visible_points(settings, eye_paths));
    std::size_t guide = 0;
    if (settings.guide == GuideKind::Paper) {
        guide = PaperGuide::memory_bound_bytes(settings);
        if (settings.error_criterion == CriterionKind::Image) {
            guide += IterationScores::memory_bound_bytes(points, iteration_photons(settings));
        }
    }
    if (settings.guide == GuideKind::Adaptive) {
        guide = AdaptiveGuide::memory_bound_bytes(scene, settings, points) +
                log_bytes(settings, kIterationPaths);
    }
    std::size_t radii = ScheduledRadius::memory_bound_bytes(points);
    if (settings.mode == Mode::Ppm) radii = PpmRadius::memory_bound_bytes(points);
    if (adapts_radius(settings)) {
        // And the flux's probes and inner halves of discs.
        const std::size_t inner = settings.narrow_radii ? sizeof(Rgb) : 0;
        radii = AdaptiveRadius::memory_bound_bytes(pixels, points, settings.narrow_radii) +
                points * (sizeof(ProbeSums) + inner);
    }
    // What the photons per pass and the adaptive guide go by.
    const std::size_t plan = PixelImportance::memory_bound_bytes(pixels) +
                             PassNoiseMeter::memory_bound_bytes(pixels) +
                             eye_paths * (sizeof(PixelLuminance) + 2 * sizeof(float));
    const std::size_t edges =
        settings.correct_edges ? EdgeCorrection::memory_bound_bytes(pixels, points) : 0;
    const std::size_t occlusion =
        settings.photon_occlusion ? PhotonOcclusion::memory_bound_bytes(pixels, points) : 0;
    const std::size_t gloss = settings.caustics_on_gloss
                                  ? GlossTable::memory_bound_bytes() + points * sizeof(GlossyFlux)
                                  : 0;
    return visible_point_bytes(scene, points) + plan + edges + gloss + occlusion +
           OccupancyGrid::memory_bound_bytes(points) + photon_bytes(scene, settings, points) +
           thread_bytes(scene) + guide + radii +
           ShareTable::memory_bound_bytes(ShareTableSettings()) +
           OwnLightNoise::memory_bound_bytes(pixels) + PhotonSquare::memory_bound_bytes(pixels) +
           volume_bytes(scene, settings, eye_paths);
}

}  // namespace aips
