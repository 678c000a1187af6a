// The choice of the photons per pass.
#include "plan/photon_schedule.h"

#include <algorithm>
#include <bit>

#include "base/constants.h"
#include "guides/adaptive/learning_weight.h"
#include "photons/photon_iteration.h"
#include "plan/constants.h"

namespace aips {
namespace {

/// Most of the photon paths of a guide's learning that count as shot where it begins with what
/// another render learned (share of kLearningPaths).
constexpr double kRememberedLearning = 1.0;

/// Most photon paths of a pass, which lasts for seconds then.
constexpr std::uint32_t kMostPerPass = 1u << 22;

/// Least photon paths of a guide's first passes.
constexpr auto kLearningPass = std::uint32_t(kLearningPaths / kWarmUpPasses);

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
    return first_paths > kLearningPass ? kChosenWeightOfAGuide : 1;
}

/// What a pass counts for, in (0, 1], of a warm start: what was learned may be wrong
/// where things have moved, and the first radii are as blind as those of any render.
double warm_start_weight(std::uint64_t pass) {
    const double known = double(pass + 1) / double(kWarmUpPasses);
    return std::min(known * known, 1.0);
}

}  // namespace

bool follows_noise(const Settings& settings) {
    // Chains' photons come in clusters, whose noise their squares do not tell.
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
      chosen_weight_(chosen_weight(paths_, learns)) {
    set_next();
}

void PhotonSchedule::set_next() {
    next_.paths = paths_;
    next_.counted = paths_;
    if (learns_) {
        next_.counted = 0;
        for (std::uint32_t first = 0; first < paths_;) {
            const std::uint32_t count = std::min(kIterationPaths, paths_ - first);
            next_.counted += learning_weight(next_.known + next_.before + first) * count;
            first += count;
        }
    }
    next_.weight = next_.counted;
    if (adapts_) next_.weight = next_.counted / paths_ * (chosen_ ? chosen_weight_ : 1);
    if (warm_start_) next_.weight *= warm_start_weight(pass_);
}

void PhotonSchedule::end_pass() {
    if (shoots()) next_.before += paths_;
    ++pass_;
    set_next();
}

void PhotonSchedule::take(const PassPlan& plan) {
    next_.chosen_at = next_.before;
    const PhotonLimits bounds = limits();
    turns_ = {.every = std::clamp(plan.turns, 1u, bounds.turns), .since = pass_};
    const double shot = std::clamp(plan.photon_paths, bounds.fewest, bounds.most) * turns_.every;
    paths_ = static_cast<std::uint32_t>(shot);
    if (adapts_) next_.thinning = plan.thinning;
    chosen_ = chosen_ || chooses();
    set_next();
}

PhotonLimits PhotonSchedule::limits() const {
    const double present = paths_ / double(turns_.every);
    if (!chooses()) return {present, present, turns_.every};
    const std::uint32_t turns = pass_ < kWarmUpPasses || !may_take_turns_ ? 1 : kMostTurns;
    return {std::max(double(kFewestPerPass), present / kGreatestFall),
            std::min(double(kMostPerPass), present * kGreatestRise), turns, kMostPerPass};
}

bool PhotonSchedule::chooses() const {
    // Without a guide half as many passes know as much.
    return adapts_ && pass_ >= (learns_ ? kWarmUpPasses : kWarmUpPasses / 2);
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
    archive.value(chosen_);
    archive.value(warm_start_);
    archive.value(next_.before);
    archive.value(next_.chosen_at);
    archive.value(next_.known);
    archive.value(next_.thinning);
    StateArchive::check(std::has_single_bit(next_.thinning), "photons left out as no plan does");
    StateArchive::check(next_.chosen_at <= next_.before,
                        "a choice of photons that is still to come");
    if (archive.restoring()) set_next();
}

void PhotonSchedule::learned(LearnedParts& parts) {
    const std::uint64_t kind = (adapts_ ? 1u : 0u) + (learns_ ? 2u : 0u);
    parts.part("photons per pass", kind << 32 | eye_paths_, [&](StateArchive& archive) {
        bool chosen = chosen_;
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
            chosen_ = true;
        }
    });
    if (parts.restoring()) set_warm_start(!parts.taken().empty());
}

void PhotonSchedule::explored(std::uint64_t paths) {
    if (!learns_) return;
    next_.known = std::max(next_.known, paths);
    if (adapts_ && !chosen_) {
        const double left = std::max(0.0, kLearningPaths - double(next_.known));
        paths_ =
            std::clamp(eye_paths_, std::max(kFewestPerPass, std::uint32_t(left / kWarmUpPasses)),
                       kUsualPhotonsPerPass);
    }
    set_next();
}

void PhotonSchedule::begin_anew(const PhotonSchedule& fresh) {
    const bool warm_start = warm_start_;
    *this = fresh;
    set_warm_start(warm_start);
}

void PhotonSchedule::set_warm_start(bool warm_start) {
    warm_start_ = (adapts_ || learns_) && warm_start;
    set_next();
}

}  // namespace aips
