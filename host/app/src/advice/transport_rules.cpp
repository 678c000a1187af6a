// Advice by what the integrator counted.
#include <fmt/format.h>

#include <algorithm>

#include "advice/advice_rules.h"
#include "lxs/host/explanation.h"

namespace lxs {
namespace {

constexpr double kCutShare = 0.02;  ///< of paths; fewer that are cut are not seen to be missing
constexpr double kMostPhotons = 0.9;
constexpr double kLeastImage = 0.02;
constexpr std::uint64_t kPathsThatTell = 10'000;

double share_of(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

AdviceText photon_depth_cuts_caustics(const AdviceFacts& facts) {
    std::uint64_t cut = 0;
    for (const MaterialStatistics& material : facts.transport.materials)
        cut += material.cut_passing;
    const double part = share_of(cut, told_photon_paths(facts.transport));
    if (part < kCutShare) return {};
    return fmt::format(
        "{:.0f} % of the photons end within glass or between mirrors, as maxphotondepth allows no "
        "more surfaces: their caustics are missing. Raise maxphotondepth.",
        100 * part);
}

AdviceText eye_depth_cuts_glass(const AdviceFacts& facts) {
    const double part = share_of(facts.transport.cut_eye_paths, facts.transport.eye_paths);
    if (part < kCutShare) return {};
    return fmt::format(
        "{:.0f} % of the eye paths end within glass or between mirrors, as maxeyedepth allows no "
        "more surfaces: the image is black there. Raise maxeyedepth.",
        100 * part);
}

AdviceText light_takes_photons_for_nothing(const AdviceFacts& facts) {
    const auto& lights = facts.transport.lights;
    const std::uint64_t paths = told_photon_paths(facts.transport);
    const double total = told_luminance(facts.transport);
    // What photons bring in media is told of no light.
    if (paths < kPathsThatTell || !(total > 0) || facts.session.scene->facts().has_scattering_media)
        return {};
    for (std::size_t i = 0; i < std::min(lights.size(), facts.session.scene->lights().size());
         ++i) {
        const double of_photons = share_of(lights[i].photon_paths, paths);
        const double of_image = (lights[i].seen + lights[i].photons) / total;
        if (of_photons < kMostPhotons || of_image > kLeastImage) continue;
        return fmt::format(
            "{} takes {:.0f} % of the photons and brings {:.2g} % of the image, so that what the "
            "others light is noisy. Leave it out, or let guide \"adaptive\" send photons where "
            "they are seen.",
            light_name(facts.session, i), 100 * of_photons, 100 * of_image);
    }
    return {};
}

}  // namespace lxs
