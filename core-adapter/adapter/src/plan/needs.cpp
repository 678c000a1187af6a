// Analysis of what a scene needs.
#include "plan/needs.h"

#include <algorithm>

#include "eye/eye_pass.h"
#include "eye/light_choice.h"

namespace aips {
namespace {

void skip(Needs& needs, std::string part, const std::string& reason) {
    needs.skipped.push_back(std::move(part) + ": " + reason);
}

/// Why no eye path goes on from a visible point, photons apart; empty if some may.
std::string why_none_continue(const Settings& settings, const Scene& scene) {
    if (!settings.direct_light_sampling) return "no shadow rays";
    if (freezes_eye_pass(settings.mode)) return "eye paths belong to one pass";
    if (settings.guide == GuideKind::Paper) return "the paper's photons carry all indirect light";
    if (scene.media()) return "photons carry what media scatter";
    return {};
}

/// Why photons bring nothing to glossy lobes that bounce eye paths on; empty if they may.
std::string why_no_photons_on_gloss(const Settings& settings, const Scene& scene) {
    const LobeMask lobes = scene.facts().lobes;
    if (settings.store_glossy) return "glossy lobes take all photons";
    if (!(lobes & kGlossy)) return "no surface is glossy";
    if (!settings.continue_eye_paths || !why_none_continue(settings, scene).empty())
        return "eye paths share no light with photons";
    return {};
}

/// Why no photon could bring light; empty if one could.
std::string why_no_photons(const Settings& settings, const Scene& scene, bool any_light) {
    if (!any_light) return "no light emits";
    const bool any_takes = (scene.facts().lobes & receiving_lobes(settings)) ||
                           (settings.caustics_on_gloss && (scene.facts().lobes & kSpecular) &&
                            why_no_photons_on_gloss(settings, scene).empty());
    if (!any_takes && !scene.media()) return "no surface takes photons";
    if (settings.direct_light_sampling && !photons_may_scatter(settings)) {
        return "shadow rays carry all light at this photon depth";
    }
    return {};
}

void drop_guide(Needs& needs, const std::string& reason) {
    needs.settings.guide = GuideKind::None;
    skip(needs, "guide", reason);
}

/// Nothing that waits for photons is set up.
void drop_photons(Needs& needs, const std::string& reason) {
    needs.photons = false;
    needs.settings.photon_sampler = PhotonSampler::Sequence;
    needs.settings.radius = RadiusKind::Schedule;
    skip(needs, "photon pass", reason);
}

/// Parts of guide=adaptive that nothing would ever ask.
void drop_adaptive_parts(Needs& needs, const SceneFacts& facts) {
    Settings& s = needs.settings;
    const bool bounce = photons_may_scatter(s);
    if (s.guide_survival && !bounce) {
        s.guide_survival = false;
        skip(needs, "survival by score", "no photon goes on at this photon depth");
    }
    if (s.guide_bounces && !(bounce && (facts.lobes & kDiffuse))) {
        s.guide_bounces = false;
        skip(needs, "guided bounces",
             bounce ? "no surface is diffuse" : "no photon goes on at this photon depth");
    }
}

/// A choice among lights is worth learning where there is one and each pass looks anew.
void drop_learned_lights(Needs& needs, std::size_t living, const SceneFacts& facts) {
    Settings& s = needs.settings;
    if (!s.learn_lights) return;
    std::string reason;
    if (!s.direct_light_sampling) {
        reason = "no shadow rays";
    } else if (living < 2) {
        reason = "nothing to choose from";
    } else if (freezes_eye_pass(s.mode)) {
        reason = "shadow rays belong to one pass";
    } else if (!(facts.lobes & kNonSpecular)) {
        reason = "no surface that asks for lights";
    }
    if (reason.empty()) return;
    s.learn_lights = false;
    skip(needs, "learned choice of lights", reason);
}

/// Eye paths share light with photons where both find the same, and each pass looks anew.
void drop_continued_paths(Needs& needs, const Scene& scene) {
    Settings& s = needs.settings;
    if (!s.continue_eye_paths) return;
    const std::string reason =
        needs.photons ? why_none_continue(s, scene) : "no light to share with photons";
    if (reason.empty()) return;
    s.continue_eye_paths = false;
    skip(needs, "continued eye paths", reason);
}

/// Photons bring light to glossy lobes where they share it with eye paths at all.
void drop_photons_on_gloss(Needs& needs, const Scene& scene) {
    Settings& s = needs.settings;
    if (!s.caustics_on_gloss) return;
    const std::string reason = why_no_photons_on_gloss(s, scene);
    if (reason.empty()) return;
    s.caustics_on_gloss = false;
    skip(needs, "photons on gloss beside bounces", reason);
}

/// The modes with frozen eye passes are those of their papers.
void drop_edge_correction(Needs& needs) {
    Settings& s = needs.settings;
    if (!s.correct_edges) return;
    std::string reason;
    if (!needs.photons) {
        reason = "no photons to gather";
    } else if (freezes_eye_pass(s.mode)) {
        reason = "the mode's density estimate has none";
    }
    if (reason.empty()) return;
    s.correct_edges = false;
    skip(needs, "correction of edges", reason);
}

/// Photons that are not gathered are not asked for.
void drop_occlusion(Needs& needs) {
    if (!needs.settings.photon_occlusion || needs.photons) return;
    needs.settings.photon_occlusion = false;
    skip(needs, "rays between photons and visible points", "no photons to gather");
}

/// Blur narrows radii that adapt.
void drop_narrowing(Needs& needs) {
    Settings& s = needs.settings;
    if (!s.narrow_radii || adapts_radius(s)) return;
    s.narrow_radii = false;
    skip(needs, "radii that blur narrows",
         needs.photons ? "radii do not adapt" : "no photons to gather");
}

/// Emitter paths meet emitters behind specular surfaces, in each pass anew.
void drop_emitter_paths(Needs& needs, const SceneFacts& facts, bool any_light) {
    Settings& s = needs.settings;
    if (!s.guide_emitters) return;
    std::string reason;
    if (!any_light) {
        reason = "no light emits";
    } else if (!(facts.lobes & kSpecular)) {
        reason = "no surface is specular";
    } else if (eye_depth(s).surfaces < 2) {
        reason = "eye paths end at the first surface";
    } else if (freezes_eye_pass(s.mode)) {
        reason = "eye paths belong to one pass";
    } else if (s.guide == GuideKind::Paper) {
        reason = "the paper's eye paths meet emitters by themselves";
    }
    if (reason.empty()) return;
    s.guide_emitters = false;
    skip(needs, "emitter paths", reason);
}

void drop_guides(Needs& needs, const SceneFacts& facts) {
    const Settings& s = needs.settings;
    if (s.guide == GuideKind::None) {
        skip(needs, "guide", "not asked for");
    } else if (!needs.photons) {
        drop_guide(needs, "no photons to guide");
    } else if (s.guide == GuideKind::Adaptive) {
        drop_adaptive_parts(needs, facts);
    } else if (!photons_may_scatter(s)) {
        drop_guide(needs, "no photon goes on at this photon depth");
    }
}

/// Parts that know of light on surfaces alone, and would lead photons past media that scatter.
void drop_parts_for_surfaces(Needs& needs, const SceneFacts& facts) {
    Settings& s = needs.settings;
    if (s.photon_sampler == PhotonSampler::AdaptiveChains) {
        s.photon_sampler = PhotonSampler::Sequence;
        skip(needs, "photonsampler amc", "its chains do not know which photons are seen in media");
    }
    if (s.guide == GuideKind::Adaptive && s.guide_chains) {
        s.guide_chains = false;
        skip(needs, "Markov chains", "they do not know which photons are seen in media");
    }
    if (s.guide == GuideKind::Adaptive && s.guide_survival) {
        s.guide_survival = false;
        skip(needs, "survival by score", "scores do not know what light in media is worth");
    }
    if (s.guide != GuideKind::None && !(facts.lobes & receiving_lobes(s))) {
        drop_guide(needs, "no surface takes photons");
    }
}

}  // namespace

Needs analyse(const Scene& scene, const Settings& settings) {
    Needs needs;
    needs.settings = settings;
    // Decided once, by what is asked for: parts that are left out below change no radius.
    needs.settings.radius = adapts_radius(settings) ? RadiusKind::Adaptive : RadiusKind::Schedule;
    const SceneFacts facts = scene.facts();
    const auto lights = scene.lights();
    const auto dead = std::size_t(std::count_if(lights.begin(), lights.end(),
                                                [](const Light* light) { return !emits(*light); }));
    const std::string reason = why_no_photons(settings, scene, dead < lights.size());
    if (!reason.empty()) drop_photons(needs, reason);
    if (dead > 0) {
        skip(needs, std::to_string(dead) + (dead == 1 ? " light" : " lights"),
             "no power, so neither photons nor shadow rays go there");
    }
    if (needs.photons && settings.direct_light_sampling) {
        skip(needs, "direct photons", "shadow rays carry direct light");
    }
    drop_learned_lights(needs, lights.size() - dead, facts);
    drop_continued_paths(needs, scene);
    drop_photons_on_gloss(needs, scene);
    drop_edge_correction(needs);
    drop_occlusion(needs);
    drop_narrowing(needs);
    drop_emitter_paths(needs, facts, dead < lights.size());
    if (scene.media()) drop_parts_for_surfaces(needs, facts);
    drop_guides(needs, facts);
    if (!facts.has_media) {
        skip(needs, "media", "none in the scene");
    } else if (!scene.media()) {
        skip(needs, "light scattered by media", "none of them scatters");
    }
    return needs;
}

}  // namespace aips
