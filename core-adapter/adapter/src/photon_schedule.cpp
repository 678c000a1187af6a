// The choice of the photons per pass.
#include "photon_schedule.h"

#include <algorithm>
#include <cmath>

#include "learning_weight.h"

namespace aips {
namespace {

/// Photon paths a pass where they do not follow the noise and none were asked for: LuxRender's.
constexpr std::uint32_t kUsualPaths = 1'000'000;
/// Bounds of what is chosen.
constexpr std::uint32_t kFewest = 1u << 12, kMost = 1u << 22;
/// Passes before the first choice. Later ones follow whenever the passes have doubled, and change
/// the number by no more than this factor: passes count alike.
constexpr std::uint64_t kFirstPasses = 4, kFirstPassesOfAGuide = 8;
constexpr double kGreatestChange = 2;
/// What a pass after the first choice counts for, passes before at most for 1.
constexpr double kChosenWeight = 64;
/// Greatest ratio of a pass's two costs: beyond it less noise on one side can't save 1 / 16.
constexpr double kUnevenness = 16;

bool follows_noise(const Settings& settings) {
    // Chains' landings come in clusters, whose noise their squares do not tell.
    return settings.photons_per_pass == 0 && settings.mode == Mode::Progressive &&
           settings.photon_sampler == PhotonSampler::Sequence;
}

/// Before anything is known: as many as eye paths, or what a guide has to learn from.
std::uint32_t first_paths(const Settings& settings, std::uint32_t eye_paths, bool adapts,
                          bool learns) {
    if (adapts && learns) return std::uint32_t(kLearningPaths / kFirstPassesOfAGuide);
    if (adapts) return std::clamp(eye_paths, kFewest, kUsualPaths);
    return settings.photons_per_pass ? settings.photons_per_pass : kUsualPaths;
}

}  // namespace

PhotonSchedule::PhotonSchedule(const Settings& settings, std::uint32_t eye_paths, bool learns)
    : adapts_(follows_noise(settings)),
      learns_(learns),
      paths_(first_paths(settings, eye_paths, adapts_, learns)),
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
    if (adapts_) next_.weight = decided_ ? kChosenWeight : next_.counted / paths_;
}

void PhotonSchedule::end_pass(const PassWork& work, const PassNoise& noise) {
    ++pass_;
    next_.before += paths_;
    if (2 * pass_ > decide_at_) {
        work_.eye += work.eye;
        work_.photons += work.photons;
        noise_.eye += noise.eye;
        noise_.photon_path += noise.photon_path;
        shot_ += paths_;
    }
    if (adapts_ && pass_ == decide_at_) {
        paths_ = best_paths();
        decide_at_ *= 2;
        decided_ = true;
        work_ = {};
        noise_ = {};
        shot_ = 0;
    }
    plan();
}

std::uint32_t PhotonSchedule::best_paths() const {
    const double passes = double(shot_) / paths_;
    const double eye_cost = work_.eye / passes;
    const double path_cost = work_.photons / double(shot_);
    if (!(eye_cost > 0 && path_cost > 0)) return paths_;
    const double even = eye_cost / path_cost;
    double paths = even * kUnevenness;
    // Noise that photons explain altogether leaves less than none to the eye, by chance.
    if (noise_.eye > 0) paths = std::sqrt(even * std::max(0.0, noise_.photon_path) / noise_.eye);
    paths = std::clamp(paths, even / kUnevenness, even * kUnevenness);
    if (decided_) paths = std::clamp(paths, paths_ / kGreatestChange, paths_ * kGreatestChange);
    return static_cast<std::uint32_t>(std::clamp(paths, double(kFewest), double(kMost)));
}

}  // namespace aips
