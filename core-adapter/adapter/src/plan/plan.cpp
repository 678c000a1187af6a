// What runs in a render.
#include "plan/plan.h"

#include "eye/eye_source.h"
#include "plan/photon_schedule.h"
#include "radii/radius_policy.h"

namespace aips {
namespace {

std::string eye_paths_of(const Plan& plan) {
    if (freezes_eye_pass(plan.settings().mode)) return "eye paths of one pass, kept";
    return plan.settings().guide_emitters ? "new eye paths and emitter paths in each pass"
                                          : "new eye paths in each pass";
}

std::string photon_paths_of(const Plan& plan) {
    if (!plan.needs.photons) return "no photons";
    if (plan.chains()) return "photon paths of Markov chains";
    switch (plan.guide()) {
        case GuideKind::None:
            return "unguided photon paths";
        case GuideKind::Paper:
            return "photon paths guided by errors (Liu and Zheng 2014)";
        case GuideKind::Adaptive:
            return plan.has_pilot_pass()
                       ? "photon paths guided by their contribution, after a pilot pass"
                       : "photon paths guided by their contribution";
    }
    return {};
}

std::string radii_of(const Plan& plan) {
    if (plan.settings().mode == Mode::Ppm) return "radii by the photons of each visible point";
    if (plan.settings().mode == Mode::PhotonMap) return "one radius, fixed";
    return adapts_radius(plan.settings()) ? "radii by noise and bias"
                                          : "one radius, by the photons shot";
}

}  // namespace

GuideKind Plan::guide() const {
    const bool left_out = settings().guide == GuideKind::Adaptive && way != PhotonWay::Guided;
    return left_out ? GuideKind::None : settings().guide;
}

bool Plan::has_pilot_pass() const {
    return needs.photons && settings().guide == GuideKind::Adaptive && settings().pilot_pass &&
           !media;
}

bool Plan::measures_noise() const {
    return needs.photons && follows_noise(settings());
}

void Plan::fit_to(const Film& film) {
    if (!settings().guide_emitters) return;
    const std::uint64_t pixels = std::uint64_t{film.width()} * film.height();
    std::string reason;
    if (!film.takes_splats()) {
        reason = "the film takes no splats";
    } else if (eye_paths_per_pass(settings(), pixels) % pixels != 0) {
        // A pass that sees some pixels alone would weigh emitters by the paths of that pass.
        reason = "passes do not have the same number of eye paths in each pixel";
    }
    if (reason.empty()) return;
    needs.settings.guide_emitters = false;
    needs.skipped.push_back("emitter paths: " + reason);
}

void Plan::state(StateArchive& archive) {
    archive.value(way);
    StateArchive::check(way <= PhotonWay::Unguided && allows(way),
                        "a guide left out that was not asked for");
}

bool Plan::allows(PhotonWay other) const {
    if (other == PhotonWay::Guided) return true;
    return settings().guide == GuideKind::Adaptive && settings().pilot_pass;
}

Plan make_plan(const Scene& scene, const Settings& settings) {
    Plan plan;
    plan.needs = analyse(scene, settings);
    plan.media = scene.media() != nullptr;
    return plan;
}

std::string describe(const Plan& plan) {
    std::string text = eye_paths_of(plan) + "; " + photon_paths_of(plan);
    if (!plan.needs.photons) return text;
    text += plan.measures_noise() ? ", as many a pass as their noise asks for" : "";
    return text + "; " + radii_of(plan);
}

}  // namespace aips
