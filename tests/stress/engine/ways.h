// The ways to render that stress cases go through.
#pragma once

#include <string>
#include <vector>

#include "aips/adapter/settings.h"
#include "render_mock.h"

namespace stress {

/// A name for messages, and settings.
struct Way {
    std::string name;
    aips::Settings settings;
};

/// guide=none, paper, adaptive (with directions), and where `all` the other modes, radii and photon
/// samplers too. Small renders of `photons` a pass, a fixed radius unless the way is about it.
inline std::vector<Way> ways(std::uint64_t seed, std::uint32_t photons, bool all) {
    using namespace aips;
    const Settings plain = mock::small_settings(seed, photons);
    std::vector<Way> result{{"none", plain}, {"paper", plain}, {"adaptive", plain}};
    result[1].settings.guide = GuideKind::Paper;
    result[1].settings.iteration_photons = result[1].settings.initial_photons = 500;
    result[2].settings.guide = GuideKind::Adaptive;
    if (!all) return result;
    const auto add = [&](const char* name, auto&& change) {
        result.push_back({name, plain});
        result.back().settings.alpha = 0.7;
        change(result.back().settings);
    };
    add("sppm", [](Settings&) {});
    add("photonmap", [](Settings& s) { s.mode = Mode::PhotonMap; });
    add("ppm", [](Settings& s) { s.mode = Mode::Ppm; });
    add("radius=adaptive", [](Settings& s) { s.radius = RadiusKind::Adaptive; });
    add("chains", [](Settings& s) { s.photon_sampler = PhotonSampler::AdaptiveChains; });
    add("paper by scores", [](Settings& s) {
        s.guide = GuideKind::Paper;
        s.error_criterion = CriterionKind::Image;
        s.iteration_photons = s.initial_photons = 500;
    });
    add("by noise", [](Settings& s) { s.photons_per_pass = 0; });
    return result;
}

}  // namespace stress
