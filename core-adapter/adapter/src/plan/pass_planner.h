// What passes told of their costs and noise, gathered until the next plan, and when that comes.
#pragma once

#include "contribution/pass_noise.h"
#include "plan/pass_plan.h"
#include "plan/pass_work.h"

namespace aips {

/// A pass that shot photons, after its end.
struct EndedPass {
    std::uint64_t number = 0;
    PassWork work;  ///< the eye's with that of continued paths
    double continued_rays = 0;
    double points = 0;  ///< visible points
    std::uint64_t photon_paths = 0;
    std::uint32_t thinning = 1;  ///< PassPhotons::thinning
    PassNoise noise;
};

class PassPlanner {
  public:
    /// For a film of so many pixels and passes of so many eye paths.
    PassPlanner(std::size_t pixels, std::uint32_t eye_paths);

    void add(const EndedPass& pass);
    /// Whether a new plan comes before pass `pass`: whenever there are twice as many, and any pass
    /// was added. Numbers that are stratified over passes begin anew there, so that more often
    /// would cost what it brings.
    bool plans_before(std::uint64_t pass) const;
    /// What the passes added since the last plan told, all before pass `pass`; begins anew. That of
    /// eye paths that go on, of turns, and of photons' errors is for others to add.
    PlanFacts take(std::uint64_t pass);

    /// Saves what was added, or restores it.
    void state(StateArchive& archive);

  private:
    struct Sums {
        double passes = 0, points = 0;
        double eye_cost = 0, photon_cost = 0, photon_paths = 0;
        double beam_cost = 0;  // if beams had taken all photons
        double variance = 0, photon_path_variance = 0, beam_path_variance = 0, noisy_passes = 0;
        double thinned_variance = 0;  // beams' photons as they were taken
    };

    double pixels_, eye_paths_;
    Sums sums_;
};

}  // namespace aips
