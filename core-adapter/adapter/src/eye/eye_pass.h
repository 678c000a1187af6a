// The eye pass: eye paths up to the first surface that takes photons.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/adapter/camera.h"
#include "aips/adapter/settings.h"
#include "aips/core/base/arena.h"
#include "aips/core/photon_map/photon.h"
#include "base/luminance_by_light.h"
#include "emitter_images/emitter_images.h"
#include "eye/direct_light.h"
#include "eye/eye_shares.h"
#include "eye/point_gloss.h"
#include "eye/volume_beam.h"
#include "ranks/shared_work.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// A place in a gather disc that was asked for.
enum class DiscPlace : std::uint8_t { NotAsked, Surface, Gap };

/// Where an eye path first met a surface that takes photons.
struct VisiblePoint {
    Vec3 position;
    Vec3 geometric_normal;
    Vec3 shading_normal;
    Vec3 wo;                     ///< towards the eye
    Rgb throughput;              ///< of the eye path, divided by all its choices' probabilities
    Rgb kd;                      ///< Lambertian reflectance if `bsdf` is null
    const Bsdf* bsdf = nullptr;  ///< lives in EyeImage::arenas
    LobeMask receiving = 0;      ///< lobes that photons are gathered for
    std::uint32_t sample = 0;    ///< index of the eye path in its pass
    std::uint32_t material = 0;
    EyeScatterings scatterings;  ///< of the eye path before it
    PointGloss gloss;
    bool bounced = false;  ///< the eye path bounced on from there
    /// Photons of more bounces do not count: Settings::max_bounces bounds the whole path.
    std::uint16_t photon_bounces = kMostPhotonBounces;
    /// Share of the light that both may carry which the eye path brings by going on, in [0, 1).
    float eye_share = 0;
    DiscPlace place = DiscPlace::NotAsked;  ///< one in its gather disc
    /// Whether the path that goes on brings all of the light here, photons having lost it.
    bool fills = false;
    float eye_rays = 0;  ///< traced from there, to learn what that would bring too
    /// Whether it went on, beyond BSDF-sampled direct light, for no reason of this point alone:
    /// only such are learned from.
    bool continued = false;
    bool tells_lights = false;  ///< it is told which light's photons bring it what
    SharedDirect direct;        ///< where a BSDF-sampled ray left it

    /// Whether it takes what glossy lobes take beside their bounce alone.
    bool takes_gloss_alone() const { return gloss.bounce && !(receiving & ~kGlossy); }
    /// Share of what a path that goes on brings that counts.
    float continued_share() const { return bounced ? 0 : fills ? 1 : eye_share; }
};

/// Luminance of emitters behind specular surfaces that an eye path met and left to emitter paths.
struct EmitterRest {
    std::uint32_t sample = 0;  ///< index of the eye path in its pass
    float luminance = 0;       ///< over all light groups
};

/// What one eye pass leaves.
struct EyeImage {
    std::uint32_t groups = 1;
    std::vector<Vec2> positions;  ///< film position of each eye path
    std::vector<Rgb> radiance;    ///< [path * groups + group]: emission seen and direct light
    std::vector<Rgb> parts;       ///< [path * kImageParts + part] of that; empty if not wanted
    /// Laid out as `radiance`: what eye paths that went on from their visible points brought,
    /// without any share; empty if none may.
    std::vector<Rgb> continued;
    std::vector<SeenSurface> surfaces;  ///< [path]; empty if they are not wanted
    std::vector<VisiblePoint> visible_points;
    PointOwners owners;             ///< of these, whose Bsdfs a rank has for its own ones alone
    std::vector<VolumeBeam> beams;  ///< parts within media that scatter: at most one an eye path
    double beam_footprint_sum = 0;  ///< of the pixel footprints' radii at the beams' middles
    std::vector<Arena> arenas;      ///< one per block of eye paths; hold the visible points' Bsdfs
    double footprint_sum = 0;       ///< of the pixel footprints' radii, as footprints.h sums them
    std::vector<float> footprints;  ///< those radii, in no order; one a visible point
    std::vector<LightSample> light_samples;  ///< of some shadow rays, if they are learned from
    std::vector<EmitterRest> emitter_rests;  ///< one an eye path at most
    std::uint64_t rays = 0;
    LuminanceByLight
        light;  ///< luminance that eye paths brought by themselves, if it is to be told
    std::uint64_t telling_paths = 0;  ///< whose visible points tell, those without one included
    std::uint64_t cut_paths = 0;      ///< ended at a specular surface by the depth limit

    /// Mean radius of a pixel's footprint at the visible points, far ones bounded (footprints.h),
    /// scene units; 0 without points.
    double mean_footprint() const {
        return visible_points.empty() ? 0 : footprint_sum / double(visible_points.size());
    }
    std::size_t memory_bytes() const;
};

/// Where visible points are, in their order; reuses the memory of `positions`.
void positions_of(std::span<const VisiblePoint> points, std::vector<Vec3>& positions);

/// Where those are that take photons of all kinds, if any is: then surfaces that take caustics
/// alone are not looked at in `settings`. Else where all are.
std::vector<Vec3> positions_of_most_photons(std::span<const VisiblePoint> points,
                                            Settings& settings);

/// Luminance of an eye path, or of a visible point, over its light groups in `values`:
/// [path * groups + group].
inline float luminance_over_groups(std::span<const Rgb> values, std::size_t path,
                                   std::uint32_t groups) {
    float sum = 0;
    for (std::size_t g = 0; g < groups; ++g)
        sum += luminance(values[path * groups + g]);
    return sum;
}

class DiscGaps;

/// The parts that an eye pass works with.
struct EyePassInput {
    const Scene& scene;
    const Camera& camera;
    const Sampler& sampler;
    const DirectLight& direct_light;
    const Settings& settings;
    std::uint32_t width = 0, height = 0;  ///< of the film, pixels
    std::uint32_t paths = 0;              ///< eye paths in this pass
    bool keep_visible_points = true;    ///< else they and the beams are left out, and Bsdfs dropped
    const EyeShares* shares = nullptr;  ///< null: no eye path goes on from its visible point
    const EmitterImages* emitters = nullptr;  ///< null: eye paths alone meet emitters
    LayersWanted layers = {};
    Ranks* ranks = nullptr;          ///< that share the eye paths; null: none do
    const DiscGaps* gaps = nullptr;  ///< null: none are known
};

/// Lobes that take photons wherever they are; the others bounce the eye path on.
inline LobeMask receiving_lobes(const Settings& settings) {
    return settings.store_glossy ? kNonSpecular : kDiffuse;
}

/// Whether eye paths that leave a specular surface may meet a light.
inline bool eye_paths_meet(const Light& light, const Settings& settings) {
    return !light.is_delta() && (settings.include_environment || !light.at_infinity());
}

/// Visible points of a pass, at most: where photons may bring caustics to glossy lobes, one more of
/// each eye path.
inline std::size_t most_visible_points(const Settings& settings, std::size_t paths) {
    return paths * (settings.caustics_on_gloss ? 2 : 1);
}

/// Traces pass number `pass` at one time; `image` is refilled, its memory reused. The result does
/// not depend on the number of threads, nor on that of ranks.
void trace_eye_pass(const EyePassInput& input, std::uint64_t pass, float time,
                    InvalidSampleFilter& filter, EyeImage& image);

}  // namespace aips
