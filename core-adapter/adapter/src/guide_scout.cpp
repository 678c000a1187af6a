// Photon paths that are followed only to see whether they are seen.
#include "guide_scout.h"

#include <algorithm>
#include <limits>

#include "light_choice.h"
#include "photon_iteration.h"

namespace aips {
namespace {

/// Number of the pass and of the first path in the render: none that brings light has them.
constexpr std::uint64_t kNoPass = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kFirstPath = std::uint64_t{1} << 62;

}  // namespace

double seen_share(const Scene& scene, const Settings& settings, float time, const EyeImage& image,
                  float radius) {
    OccupancyGrid occupancy;
    occupancy.build(positions_of(image.visible_points), radius);

    const DiscreteDistribution choice = light_choice(scene);
    PhotonInput input{scene, settings, choice};
    input.occupancy = &occupancy;
    input.pass = kNoPass;
    input.time = time;
    input.log_one_of = 1;
    Refusals refusals(scene);
    LandingStore landings;
    PathLog log;
    PhotonTracer().trace(input, kFirstPath, 0, kPlainIterationPaths, refusals, landings, &log);
    const auto seen =
        std::ranges::count_if(log.paths, [](const PathRecord& path) { return path.landings > 0; });
    return double(seen) / kPlainIterationPaths;
}

}  // namespace aips
