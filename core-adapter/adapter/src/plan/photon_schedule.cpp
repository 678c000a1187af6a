// The choice of the photons per pass.
#include "plan/photon_schedule.h"

#include <algorithm>
#include <cmath>

#include "guides/adaptive/learning_weight.h"
#include "photons/photon_iteration.h"
#include "plan/constants.h"

namespace aips {
namespace {

/// Most of the photon paths of a guide's learning that count as shot where it begins with what
/// another render learned (share of kLearningPaths).
constexpr double kRememberedLearning = 1.0;

/// Least photon paths of a guide's first passes.
constexpr auto kLearningPass = std::uint32_t(kLearningPaths / kFirstPassesOfAGuide);

/// Before anything is known: as many as eye paths, and at least what a guide has to learn from.
std::uint32_t first_paths(const Settings& settings, std::uint32_t eye_paths, bool adapts,
                          bool learns) {
    if (!adapts)
        return settings.photons_per_pass ? settings.photons_per_pass : kUsualPhotonsPerPass;
    const std::uint32_t fewest = learns ? kLearningPass : kFewestPerPass;
    return std::clamp(eye_paths, fewest, kUsualPhotonsPerPass);
}

double chosen_weight(std::uint32_t first_paths, bool learns) {
    if (!learns) return kChosenWeight;
    return first_paths > kLearningPass ? kChosenWeightOfAGuide : kChosenWeightInSmallImages;
}

/// What a pass counts for, in (0, 1], of a render that was taught: what was learned may be wrong
/// where things have moved, and the first radii are as blind as those of any render.
double taught_weight(std::uint64_t pass) {
    static_assert(kTurnsFrom >= kTaughtPasses, "passes without photons leave the weight as it is");
    const double known = double(pass + 1) / kTaughtPasses;
    return std::min(known * known, 1.0);
}

}  // namespace

bool follows_noise(const Settings& settings) {
    // Chains' landings come in clusters, whose noise their squares do not tell.
    return settings.photons_per_pass == 0 && settings.mode == Mode::Progressive &&
           settings.photon_sampler == PhotonSampler::Sequence;
}

PhotonSchedule::PhotonSchedule(const Settings& settings, std::uint32_t eye_paths, bool shoots,
                               bool learns, bool may_take_turns)
    : seed_(settings.seed),
      adapts_(shoots && follows_noise(settings)),
      learns_(learns),
      may_take_turns_(may_take_turns),
      eye_paths_(eye_paths),
      paths_(first_paths(settings, eye_paths, adapts_, learns)),
      chosen_weight_(chosen_weight(paths_, learns)),
      decide_at_(learns ? kFirstPassesOfAGuide : kFirstPasses) {
    plan();
}

void PhotonSchedule::plan() {
    next_.paths = paths_;
    next_.counted = paths_;
    if (learns_) {
        next_.counted = 0;
        for (std::uint32_t first = 0; first < paths_;) {
            const std::uint32_t count = std::min(kLearningIterationPaths, paths_ - first);
            next_.counted += learning_weight(next_.known + next_.before + first) * count;
            first += count;
        }
    }
    next_.weight = next_.counted;
    if (adapts_) next_.weight = next_.counted / paths_ * (decided_ ? chosen_weight_ : 1);
    if (taught_) next_.weight *= taught_weight(pass_);
}

void PhotonSchedule::end_pass(const PassWork& work, const PassNoise& noise) {
    ++pass_;
    next_.before += paths_;
    // What comes first, the eye's estimate of the image or a guide, is blind.
    if (decided_ || 2 * pass_ > decide_at_) {
        work_.eye += work.eye;
        work_.photons += work.photons;
        noise_.eye += noise.eye;
        noise_.photon_path += noise.photon_path;
        shot_ += paths_;
    }
    if (adapts_ && !planned_ && pass_ == decide_at_) {
        paths_ = best_paths();
        work_ = {};
        noise_ = {};
        shot_ = 0;
        decide_at_ += std::max<std::uint64_t>(2, pass_ / 4);
        decided_ = true;
        next_.chosen_at = next_.before;
    }
    plan();
}

void PhotonSchedule::take(double paths, std::uint32_t every) {
    planned_ = true;
    next_.chosen_at = next_.before;
    const PhotonLimits bounds = limits();
    turns_ = {.every = std::clamp(every, 1u, bounds.turns), .since = pass_};
    const double shot = std::clamp(paths, bounds.fewest, bounds.most) * turns_.every;
    paths_ = static_cast<std::uint32_t>(shot);
    decided_ = decided_ || pass_ >= decide_at_;
    plan();
}

PhotonLimits PhotonSchedule::limits() const {
    const double present = paths_ / double(turns_.every);
    // A guide is still learning.
    if (!adapts_ || pass_ < decide_at_) return {present, present, turns_.every};
    const std::uint32_t turns = pass_ < kTurnsFrom || !may_take_turns_ ? 1 : kMostTurns;
    return {std::max(double(kFewestPerPass), present / kGreatestPlannedFall),
            std::min(double(kMostPerPass), present * kGreatestPlannedRise), turns, kMostPerPass};
}

void PhotonSchedule::state(StateArchive& archive) {
    const std::uint32_t present = paths_;
    archive.value(paths_);
    StateArchive::check(
        adapts_ ? paths_ >= kFewestPerPass && paths_ <= kMostPerPass : paths_ == present,
        "a number of photons that no pass has");
    turns_.state(archive);
    archive.value(pass_);
    StateArchive::check(turns_.every == 1 || (adapts_ && may_take_turns_ && turns_.since <= pass_ &&
                                              turns_.since % turns_.every == 0),
                        "passes without photons where all shoot");
    archive.value(decide_at_);
    archive.value(decided_);
    archive.value(planned_);
    archive.value(taught_);
    archive.value(next_.before);
    archive.value(next_.chosen_at);
    archive.value(next_.known);
    StateArchive::check(
        next_.chosen_at <= next_.before && (decided_ || planned_ || next_.chosen_at == 0),
        "a choice of photons that is still to come");
    for (double* sum : {&work_.eye, &work_.photons})
        archive.amount(*sum);
    // Estimates, which may be anything.
    for (double* sum : {&noise_.eye, &noise_.photon_path})
        archive.value(*sum);
    archive.value(shot_);
    if (archive.restoring()) plan();
}

void PhotonSchedule::learned(LearnedParts& parts) {
    const std::uint64_t kind = (adapts_ ? 1u : 0u) + (learns_ ? 2u : 0u);
    parts.part("photons per pass", kind << 32 | eye_paths_, [&](StateArchive& archive) {
        bool chosen = decided_ || planned_;
        std::uint32_t paths = paths_ / turns_.every;
        std::uint64_t known = next_.known + next_.before;
        archive.value(chosen);
        archive.value(paths);
        archive.value(known);
        StateArchive::check(!adapts_ || (paths >= kFewestPerPass && paths <= kMostPerPass),
                            "a number of photons that no pass has");
        if (!archive.restoring()) return;
        next_.known = std::min(known, std::uint64_t(kRememberedLearning * kLearningPaths));
        if (adapts_ && chosen) {
            paths_ = paths;
            decided_ = true;
        }
    });
    if (parts.restoring()) set_taught(!parts.taken().empty());
}

void PhotonSchedule::explored(std::uint64_t paths) {
    if (!learns_) return;
    next_.known = std::max(next_.known, paths);
    if (adapts_ && !decided_) {
        const double left = std::max(0.0, kLearningPaths - double(next_.known));
        paths_ = std::clamp(eye_paths_,
                            std::max(kFewestPerPass, std::uint32_t(left / kFirstPassesOfAGuide)),
                            kUsualPhotonsPerPass);
    }
    plan();
}

void PhotonSchedule::begin_anew(const PhotonSchedule& fresh) {
    const bool taught = taught_;
    *this = fresh;
    set_taught(taught);
}

void PhotonSchedule::set_taught(bool taught) {
    taught_ = (adapts_ || learns_) && taught;
    plan();
}

double PhotonSchedule::even_paths() const {
    const double passes = double(shot_) / paths_;
    const double eye_cost = work_.eye / passes;
    const double path_cost = work_.photons / double(shot_);
    return eye_cost > 0 && path_cost > 0 ? eye_cost / path_cost : 0;
}

double PhotonSchedule::best_ratio() const {
    // Noise that photons explain altogether leaves less than none to the eye, by chance.
    if (!(noise_.eye > 0)) return kGreatestRatio;
    const double ratio = std::sqrt(std::max(0.0, noise_.photon_path) / (noise_.eye * even_paths()));
    return std::isnan(ratio) ? kGreatestRatio : std::clamp(ratio, kLeastRatio, kGreatestRatio);
}

std::uint32_t PhotonSchedule::best_paths() const {
    const double even = even_paths();
    if (!(even > 0) || !std::isfinite(even)) return paths_;
    double paths = even * best_ratio();
    if (decided_ || learns_) {
        // A guide that has just learned will do with less.
        const double rise = decided_ ? kGreatestRise : 1;
        paths = std::clamp(paths, paths_ / kGreatestFall, paths_ * rise);
    }
    return static_cast<std::uint32_t>(
        std::clamp(paths, double(kFewestPerPass), double(kMostPerPass)));
}

}  // namespace aips
