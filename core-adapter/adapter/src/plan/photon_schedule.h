// How many photon paths each pass shoots, as planned (pass_plan.h), and what they weigh in the
// image.
//
// The photons' part of the image is a mean over passes with weights that depend on a pass's number
// alone, so what their number follows does not change its expectation. The first passes, with
// numbers chosen blindly, count for little.
#pragma once

#include <cstdint>

#include "aips/adapter/settings.h"
#include "aips/core/base/learned_parts.h"
#include "estimate/pass_photons.h"
#include "plan/pass_plan.h"
#include "plan/photon_turns.h"

namespace aips {

/// Whether the photons per pass follow the noise that passes tell.
bool follows_noise(const Settings& settings);

class PhotonSchedule {
  public:
    /// `shoots`: photons are needed at all; `learns`: the first photon paths count for less
    /// (learning_weight.h); `may_take_turns`: some passes may be without.
    PhotonSchedule(const Settings& settings, std::uint32_t eye_paths, bool shoots, bool learns,
                   bool may_take_turns = true);

    /// The pass that comes next, if it shoots.
    const PassPhotons& next() const { return next_; }
    /// Whether it does.
    bool shoots() const { return turns_.shoots(seed_, pass_); }
    /// One of so many passes does; what its photons count for.
    std::uint32_t turns() const { return turns_.every; }
    /// Whether numbers follow what passes tell.
    bool adapts() const { return adapts_; }
    /// A pass has ended, which shot photons or, in its turn, none.
    void end_pass();
    /// Between passes: what those that come shoot. Numbers that are stratified over passes begin
    /// anew.
    void take(const PassPlan& plan);
    /// What the next plan may be; where nothing adapts, what is.
    PhotonLimits limits() const;
    /// Between passes: saves what is planned and what that rests on, or restores it into a new
    /// schedule with the same settings.
    void state(StateArchive& archive);
    /// Saves for another render with as many eye paths what this one would go on with, or takes it
    /// before the first pass: the number is chosen by then, and a guide has learned. Where
    /// this or any part before it is taken, the render is a warm start, and first passes count
    /// less.
    void learned(LearnedParts& parts);
    /// Before the first pass: so many photon paths have told the guide where to start. They count
    /// as shot, and the guide's first passes have fewer.
    void explored(std::uint64_t paths);
    /// Takes the settings and state of a new schedule, but for a warm start.
    void begin_anew(const PhotonSchedule& fresh);

  private:
    void set_warm_start(bool warm_start);
    void set_next();
    /// Whether enough is known for the next plan to change the number.
    bool chooses() const;

    std::uint64_t seed_;
    bool adapts_, learns_, may_take_turns_;
    std::uint32_t eye_paths_;
    std::uint32_t paths_;  // of a pass that shoots
    PhotonTurns turns_;
    double chosen_weight_;  // of passes after the first choice
    std::uint64_t pass_ = 0;
    bool chosen_ = false;      // the number of photon paths
    bool warm_start_ = false;  // by another render
    PassPhotons next_;         // `known` of it is that of all passes
};

}  // namespace aips
