// Radius of mode=progressive and mode=photonmap.
#include "scheduled_radius.h"

#include "aips/core/radius_schedule.h"

namespace aips {
namespace {

/// Photon paths after which the radius schedule has made one step of Knaus & Zwicker (2011): a
/// constant, so that methods with other numbers of photons per pass keep equal radii at equal work.
constexpr double kReferencePaths = 1e6;

}  // namespace

SearchRadii ScheduledRadius::before_pass(std::uint64_t pass, const EyeImage& image) {
    if (!(initial_ > 0)) initial_ = initial_radius(settings_, image, smallest_);
    if (settings_.mode == Mode::PhotonMap) return float(initial_);
    const double shot = double(pass) * double(settings_.photons_per_pass);
    return knaus_zwicker_radius(initial_, shot, kReferencePaths, settings_.alpha, smallest_);
}

}  // namespace aips
