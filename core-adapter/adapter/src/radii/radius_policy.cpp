// Choice of the radius policy, and where all of them start.
#include "radii/radius_policy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radii/adaptive_radius.h"
#include "radii/ppm_radius.h"
#include "radii/scheduled_radius.h"

namespace aips {
namespace {

/// Smallest radius that is the same for all of a pass (share of the scene's diagonal).
constexpr double kMinRadiusShare = 1e-7;

}  // namespace

std::unique_ptr<RadiusPolicy> make_radius_policy(const Settings& settings, const Scene& scene,
                                                 std::uint32_t width, std::uint32_t height) {
    if (settings.mode == Mode::Ppm) return std::make_unique<PpmRadius>(settings, scene);
    if (adapts_radius(settings)) {
        return std::make_unique<AdaptiveRadius>(settings, scene, width, height);
    }
    return std::make_unique<ScheduledRadius>(settings, scene);
}

double smallest_radius(const Scene& scene) {
    const auto diagonal = double(scene.bounds().diagonal());
    return std::isfinite(diagonal) ? kMinRadiusShare * diagonal : 0;
}

double initial_radius(const Settings& settings, const EyeImage& image, double smallest) {
    return radius_of_footprint(settings, image.mean_footprint(), smallest);
}

void state_of_initial_radius(StateArchive& archive, double& radius, double smallest) {
    using Limits = std::numeric_limits<float>;
    // Radii that adapt may be some times as wide.
    constexpr double kGreatest = double(Limits::max()) / 64;
    archive.value(radius);
    StateArchive::check(
        radius == 0 || (radius >= std::max(smallest, double(Limits::min())) && radius <= kGreatest),
        "a gather radius that no pass can have begun with");
}

double radius_of_footprint(const Settings& settings, double footprint, double smallest) {
    const double footprints = settings.start_radius > 0 ? settings.start_radius : kAutomaticRadius;
    return std::max(footprints * 2 * footprint, smallest);
}

}  // namespace aips
