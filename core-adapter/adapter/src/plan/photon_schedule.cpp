// The choice of the photons per pass.
#include "plan/photon_schedule.h"

#include <algorithm>
#include <cmath>

#include "guides/adaptive/learning_weight.h"
#include "photons/photon_iteration.h"

namespace aips {
namespace {

/// Bounds of what is chosen.
constexpr std::uint32_t kFewest = 1u << 12, kMost = 1u << 22;
/// Chains find their paths anew in each pass: short ones find none where they are rare.
constexpr std::uint32_t kFewestOfChains = 1u << 16;
/// Passes before the first choice. Others follow whenever there are a quarter more.
constexpr std::uint64_t kFirstPasses = 4, kFirstPassesOfAGuide = 8;
/// Factors by which a choice may change the last one, and that of a guide the first: passes count
/// alike, whatever they cost.
constexpr double kGreatestRise = 2, kGreatestFall = 4;
/// What a pass after the first choice counts for, those before, of few photons, for 1. A guide is
/// given more at first, and what it shoots while it learns counts for less anyway: 2 in large
/// images, whose passes it begins with as many photons as eye paths, and 1 in small ones
/// (docs/notebook/2026-11-23-weights-of-first-passes.md).
constexpr double kChosenWeight = 8, kChosenWeightOfAGuide = 2, kChosenWeightInSmallImages = 1;
/// Least photon paths of a guide's first passes.
constexpr auto kLearningPass = std::uint32_t(kLearningPaths / kFirstPassesOfAGuide);
/// Bounds of the photons' cost over the eye's. Eye paths are stratified from pass to pass, so that
/// their noise falls faster than what two passes differ by tells: at least 60 % of the time goes to
/// photons. Beyond the upper bound no more than a tenth could be gained.
constexpr double kLeastRatio = 1.5, kGreatestRatio = 10;
/// What photons from chains cost over the eye: of 10, 5 and 3 the best for the image, and as good
/// as 10 for their own light (docs/understand/photons-per-pass.md).
constexpr double kChainRatio = 5;

/// Before anything is known: as many as eye paths, and at least what a guide has to learn from.
std::uint32_t first_paths(const Settings& settings, std::uint32_t eye_paths, bool adapts,
                          bool learns, bool chains) {
    if (!adapts)
        return settings.photons_per_pass ? settings.photons_per_pass : kUsualPhotonsPerPass;
    const std::uint32_t fewest = learns ? kLearningPass : chains ? kFewestOfChains : kFewest;
    return std::clamp(eye_paths, fewest, kUsualPhotonsPerPass);
}

double chosen_weight(std::uint32_t first_paths, bool learns) {
    if (!learns) return kChosenWeight;
    return first_paths > kLearningPass ? kChosenWeightOfAGuide : kChosenWeightInSmallImages;
}

}  // namespace

bool follows_noise(const Settings& settings) {
    // Chains' landings come in clusters, whose noise their squares do not tell.
    return settings.photons_per_pass == 0 && settings.mode == Mode::Progressive &&
           settings.photon_sampler == PhotonSampler::Sequence;
}

PhotonSchedule::PhotonSchedule(const Settings& settings, std::uint32_t eye_paths, bool shoots,
                               bool learns, bool chains)
    : adapts_(shoots && follows_noise(settings)),
      learns_(learns),
      chains_(chains),
      paths_(first_paths(settings, eye_paths, adapts_, learns, chains)),
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
            const std::uint32_t count = std::min(kPlainIterationPaths, paths_ - first);
            next_.counted += learning_weight(next_.before + first) * count;
            first += count;
        }
    }
    next_.weight = next_.counted;
    if (adapts_) next_.weight = next_.counted / paths_ * (decided_ ? chosen_weight_ : 1);
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
    if (adapts_ && pass_ == decide_at_) {
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

void PhotonSchedule::state(StateArchive& archive) {
    const std::uint32_t present = paths_;
    archive.value(paths_);
    StateArchive::check(adapts_ ? paths_ >= kFewest && paths_ <= kMost : paths_ == present,
                        "a number of photons that no pass has");
    archive.value(pass_);
    archive.value(decide_at_);
    archive.value(decided_);
    archive.value(next_.before);
    archive.value(next_.chosen_at);
    StateArchive::check(next_.chosen_at <= next_.before && (decided_ || next_.chosen_at == 0),
                        "a choice of photons that is still to come");
    for (double* sum : {&work_.eye, &work_.photons})
        archive.amount(*sum);
    // Estimates, which may be anything.
    for (double* sum : {&noise_.eye, &noise_.photon_path})
        archive.value(*sum);
    archive.value(shot_);
    if (archive.restoring()) plan();
}

double PhotonSchedule::even_paths() const {
    const double passes = double(shot_) / paths_;
    const double eye_cost = work_.eye / passes;
    const double path_cost = work_.photons / double(shot_);
    return eye_cost > 0 && path_cost > 0 ? eye_cost / path_cost : 0;
}

double PhotonSchedule::best_ratio() const {
    if (chains_) return kChainRatio;
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
    const double fewest = chains_ ? kFewestOfChains : kFewest;
    return static_cast<std::uint32_t>(std::clamp(paths, fewest, double(kMost)));
}

}  // namespace aips
