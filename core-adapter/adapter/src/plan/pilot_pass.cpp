// Photon paths that are followed only to see whether they are seen.
#include "plan/pilot_pass.h"

#include <algorithm>
#include <limits>

#include "base/parallel_for.h"
#include "eye/light_choice.h"
#include "photons/photon_iteration.h"
#include "plan/constants.h"

namespace aips {
namespace {

/// Number of the pass and of the first path in the render: none that brings light has them.
constexpr std::uint64_t kNoPass = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kFirstPath = std::uint64_t{1} << 62;

}  // namespace

SeenPaths trace_pilot_pass(const Scene& scene, const Settings& settings, float time,
                           const EyeImage& image, float radius) {
    Settings of_pilot = settings;
    const std::vector<Vec3> positions = positions_of_most_photons(image.visible_points, of_pilot);
    OccupancyGrid occupancy;
    occupancy.build(positions, 2 * radius, tbb_for);
    // The false hits of hashed occupancy would outnumber what is seen of a wide scene.
    PointGrid near, reach;
    near.build(positions, 2 * radius, tbb_for);
    reach.build(positions, radius, tbb_for);

    const DiscreteDistribution choice = light_choice(scene);
    PhotonInput input{scene, of_pilot, choice};
    input.occupancy = &occupancy;
    input.pass = kNoPass;
    input.time = time;
    input.log_one_of = 1;
    input.ranks = image.owners.ranks;
    InvalidSampleFilter filter(scene);
    PhotonStore photons;
    PathLog log;
    PhotonTracer tracer;
    SeenPaths counts;
    tracer.trace(input, kFirstPath, 0, kRoundPaths, filter, photons, &log);
    counts.traced = kRoundPaths;
    for (const PathRecord& path : log.paths) {
        const auto landed = std::span(log.photons).subspan(path.first_photon, path.photons);
        const auto any_in = [&](const PointGrid& points) {
            return std::ranges::any_of(landed, [&](const Photon& photon) {
                return points.any_within_radius(photon.position);
            });
        };
        counts.near += any_in(near);
        counts.seen += any_in(reach);
    }
    return counts;
}

PhotonWay photon_way(const SeenPaths& seen) {
    return seen.near_share() >= kNearWithoutGuide ? PhotonWay::Unguided : PhotonWay::Guided;
}

bool seen_too_seldom(const SeenPaths& seen) {
    return seen.seen < kStartSplitScores;
}

}  // namespace aips
