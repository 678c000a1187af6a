// Costs fitted to the phases' times in thirteen scenes (docs/understand/photons-per-pass.md): the
// eye's rays are shaded and their film samples weighed, photons are scattered, stored, gathered and
// guided. What is learned from them is fitted by itself, in nine scenes.
#include "plan/pass_work.h"

namespace aips {
namespace {

constexpr double kEyeRay = 1.1, kEyePath = 1.2;
constexpr double kRay = 0.8, kBounce = 0.8, kGathered = 0.6;
constexpr double kGuidedEmission = 0.8, kGuidedBounce = 1.8, kLearned = 0.65;

}  // namespace

PassWork pass_work(std::uint64_t eye_paths, std::uint64_t eye_rays, const PhotonPassTotals& before,
                   const PhotonPassTotals& after) {
    const auto difference = [](std::uint64_t from, std::uint64_t to) { return double(to - from); };
    const PhotonCounts &first = before.counts, &last = after.counts;
    return {kEyeRay * double(eye_rays) + kEyePath * double(eye_paths),
            kRay * difference(first.rays, last.rays) +
                kBounce * difference(first.bounces, last.bounces) +
                kGuidedEmission * difference(first.guided_emissions, last.guided_emissions) +
                kGuidedBounce * difference(first.guided_bounces, last.guided_bounces) +
                kGathered * difference(before.gathered, after.gathered) +
                kLearned * difference(before.learned, after.learned)};
}

}  // namespace aips
