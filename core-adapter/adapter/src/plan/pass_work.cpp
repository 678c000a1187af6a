// Costs fitted to the phases' times in thirteen scenes (docs/understand/costs.md): the
// eye's rays are shaded and their film samples weighed, photons are scattered, stored, gathered and
// guided. What is learned from them is fitted by itself, in nine scenes.
#include "plan/pass_work.h"

#include "plan/constants.h"

namespace aips {

double eye_ray_work(double rays) {
    return kEyeRayWork * rays;
}

double shooting_work(double points) {
    return kPointWork * points;
}

PassWork pass_work(std::uint64_t eye_paths, std::uint64_t eye_rays, const PhotonPassTotals& before,
                   const PhotonPassTotals& after) {
    const auto difference = [](std::uint64_t from, std::uint64_t to) { return double(to - from); };
    const PhotonCounts &first = before.counts, &last = after.counts;
    return {kEyeRayWork * double(eye_rays + eye_paths) +
                kRayWork * difference(before.beam_rays, after.beam_rays),
            kRayWork * difference(first.rays, last.rays) +
                kRayWork * difference(first.bounces, last.bounces) +
                kRayWork * difference(first.guided_emissions, last.guided_emissions) +
                kGuidedBounceWork * difference(first.guided_bounces, last.guided_bounces) +
                kGatheredWork * difference(before.gathered, after.gathered) +
                kRayWork * difference(before.learned, after.learned),
            kGatheredInMediaWork * difference(before.gathered_in_media, after.gathered_in_media)};
}

}  // namespace aips
