// Radius of mode=progressive and mode=photonmap.
#include "radii/scheduled_radius.h"

#include "aips/core/radii/radius_schedule.h"
#include "radii/constants.h"

namespace aips {

float scheduled_radius(const Settings& settings, double initial, double paths_shot,
                       double smallest) {
    return knaus_zwicker_radius(initial, paths_shot, kReferencePaths, settings.alpha, smallest);
}

GatherRadii ScheduledRadius::before_pass(const PassPhotons& photons, const EyeImage& image) {
    if (!(initial_ > 0)) initial_ = initial_radius(settings_, image, floor_.least());
    const float radius =
        settings_.mode == Mode::PhotonMap
            ? float(initial_)
            : scheduled_radius(settings_, initial_, double(photons.before), floor_.least());
    raise_to_floor(image, floor_, radius, radii_);
    return radii_.empty() ? GatherRadii(radius) : GatherRadii(std::span<const float>(radii_));
}

}  // namespace aips
