// Analysis of what a scene needs.
#include "needs.h"

#include <algorithm>

namespace aips {

Needs analyse(const Scene& scene, const Settings& settings) {
    Needs needs;
    const auto lights = scene.lights();
    const auto dead = std::count_if(lights.begin(), lights.end(),
                                    [](const Light* light) { return !(light->power() > 0); });
    const auto skip_photons = [&](const std::string& reason) {
        if (needs.photons) needs.skipped.push_back("photon pass: " + reason);
        needs.photons = false;
    };
    if (std::size_t(dead) == lights.size()) skip_photons("no light emits");
    if (!scene.facts().has_receivers) skip_photons("no surface takes photons");
    if (settings.direct_light_sampling && settings.max_photon_depth < 2) {
        skip_photons("shadow rays carry all light at this photon depth");
    }
    if (needs.photons && dead > 0) {
        needs.skipped.push_back(std::to_string(dead) + " lights: they emit nothing");
    }
    if (needs.photons && settings.direct_light_sampling) {
        needs.skipped.emplace_back("direct photons: shadow rays carry direct light");
    }
    needs.guide = needs.photons && settings.guide != GuideKind::None;
    if (settings.guide == GuideKind::None) {
        needs.skipped.emplace_back("guide: not asked for");
    } else if (!needs.photons) {
        needs.skipped.emplace_back("guide: no photons to guide");
    }
    if (!scene.facts().has_media) needs.skipped.emplace_back("media: none in the scene");
    return needs;
}

}  // namespace aips
