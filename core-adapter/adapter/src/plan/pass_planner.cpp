// Sums over passes, and the facts made of them.
#include "plan/pass_planner.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/constants.h"
#include "plan/constants.h"

namespace aips {

PassPlanner::PassPlanner(std::size_t pixels, std::uint32_t eye_paths)
    : pixels_(double(pixels)), eye_paths_(double(eye_paths)) {}

void PassPlanner::add(const EndedPass& pass) {
    sums_.passes += 1;
    sums_.points += pass.points;
    sums_.eye_cost += std::max(0.0, pass.work.eye - eye_ray_work(pass.continued_rays));
    sums_.photon_cost += pass.work.photons;
    sums_.beam_cost += pass.work.beams * pass.thinning;
    sums_.photon_paths += double(pass.photon_paths);
    if (!(pass.noise.all > 0)) return;
    sums_.variance += pass.noise.all;
    sums_.photon_path_variance += pass.noise.photon_path;
    sums_.beam_path_variance += pass.noise.beam_path;
    sums_.thinned_variance += pass.thinning * pass.noise.beam_path;
    sums_.noisy_passes += 1;
}

bool PassPlanner::plans_before(std::uint64_t pass) const {
    return pass > 1 && std::has_single_bit(pass) && sums_.passes > 0;
}

PlanFacts PassPlanner::take(std::uint64_t pass) {
    const Sums sums = std::exchange(sums_, {});
    const double per_pixel = std::max(1.0, eye_paths_ / pixels_);
    // No pass has any noise while all is black: photons found nothing. Eye paths may have.
    const double noisy = std::max(1.0, sums.noisy_passes);
    PlanFacts facts;
    facts.passes = sums.passes;
    facts.passes_until = 2.0 * double(pass);
    // Early ones count little in the end, and chains may just not have found what there is.
    facts.counts_loss = pass >= kWarmUpPasses;
    facts.points = sums.points / sums.passes;
    facts.point_weight = 1 / (std::min(pixels_, eye_paths_) * per_pixel * per_pixel);
    facts.points_per_pixel = per_pixel;
    facts.variance = sums.variance / noisy;
    facts.photon_path_variance = sums.photon_path_variance / noisy;
    facts.beam_path_variance = sums.beam_path_variance / noisy;
    facts.thinned_variance = sums.thinned_variance / noisy;
    facts.photon_paths = sums.photon_paths / sums.passes;
    facts.eye_cost = sums.eye_cost / sums.passes;
    facts.shooting_cost = std::min(shooting_work(facts.points), facts.eye_cost / 2);
    facts.photon_path_cost = sums.photon_cost / std::max(1.0, sums.photon_paths);
    facts.beam_path_cost = sums.beam_cost / std::max(1.0, sums.photon_paths);
    facts.ray_cost = eye_ray_work(1);
    return facts;
}

void PassPlanner::state(StateArchive& archive) {
    for (double* sum :
         {&sums_.passes, &sums_.points, &sums_.eye_cost, &sums_.photon_cost, &sums_.photon_paths,
          &sums_.beam_cost, &sums_.variance, &sums_.photon_path_variance, &sums_.beam_path_variance,
          &sums_.thinned_variance, &sums_.noisy_passes})
        archive.amount(*sum);
}

}  // namespace aips
