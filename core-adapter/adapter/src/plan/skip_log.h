// Tells the log what is left out, and why: at the start, and when passes show more.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aips/adapter/camera.h"
#include "guides/adaptive/adaptive_guide.h"
#include "photons/exploration.h"
#include "photons/photon_path.h"
#include "plan/needs.h"
#include "plan/pass_plan.h"
#include "plan/pilot_pass.h"

namespace aips {

/// What the analysis of the scene left out.
void log_skipped(const Needs& needs, Log& log);

/// Says each thing once; parts of a guide, which are switched off and on, at each change.
class SkipLog {
  public:
    /// `log` outlives this.
    explicit SkipLog(Log& log) : log_(&log) {}

    /// A pass shot no photons, for lack of visible points; `for_good` if all passes see the same.
    void no_visible_points(bool for_good);
    /// The adaptive guide is left out, as so many unguided photon paths are seen.
    void left_out_guide(const SeenPaths& seen);
    /// Before the first pass chains looked for visible paths.
    void explored(const Exploration& exploration);
    /// It was decided who carries the light that eye paths and photons both can; said where it has
    /// changed.
    void planned(const PassPlan& plan);
    /// A pass has ended. `guide` is null but for guide=adaptive; `photons`: of all passes so far.
    void after_pass(const AdaptiveGuide* guide, const PhotonCounts& photons);
    /// What was left out since the start, as it was said.
    const std::vector<std::string>& said() const { return said_; }
    /// Saves or restores what was said, but for the texts.
    void state(StateArchive& archive);

  private:
    void say_switch(bool off, bool& was_off, const std::string& part, double gain);

    void say(const std::string& text);

    Log* log_;
    std::vector<std::string> said_;
    bool said_no_points_ = false, said_no_seeds_ = false, said_pruned_ = false;
    double said_eye_part_ = 0;  // of the light that both can carry
    bool emission_off_ = false, survival_off_ = false, disabled_ = false;
};

}  // namespace aips
