// How many photon paths each pass shoots, and what they weigh in the image.
//
// An eye path and the photons that it gathers cost time, and both are noise: with A the variance
// that eye paths leave and B that of a single photon path, a pass of N photon paths has a variance
// of A + B / N and costs a + b N. Variance times cost is least at N = sqrt(a B / (b A)).
//
// The photons' part of the image is a mean over passes with weights that depend on a pass's number
// alone, so what N follows does not change its expectation. The first passes, with numbers chosen
// blindly, count for little.
#pragma once

#include <cstdint>
#include <limits>

#include "aips/adapter/settings.h"
#include "aips/core/base/learned_parts.h"
#include "estimate/pass_photons.h"
#include "plan/photon_turns.h"
#include "worth/pass_noise.h"

namespace aips {

/// Work of a pass, counted and not measured: bits do not depend on clocks. Any unit.
struct PassWork {
    double eye = 0;  ///< independent of the number of photons
    /// Proportional to it; what a guide learns from, a part of it, becomes less with time.
    double photons = 0;
};

/// Bounds of the photon paths of a pass.
struct PhotonLimits {
    double fewest = 0, most = 0;
    std::uint32_t turns = 1;  ///< most passes of which one shoots
    double most_shot = std::numeric_limits<double>::infinity();  ///< by it
};

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
    /// A pass has ended that shot no photons, in its turn.
    void skip_pass() { ++pass_; }
    /// Whether numbers follow what passes tell: end_pass() then wants to know the noise.
    bool adapts() const { return adapts_; }
    void end_pass(const PassWork& work, const PassNoise& noise);
    /// Instead of what end_pass() decides, from the first call on: after it, so many photon paths
    /// a pass in those that come, all of `every` passes shot in one of them; numbers that are
    /// stratified over passes begin anew.
    void take(double paths, std::uint32_t every);
    /// What the next choice may be; where nothing adapts, what is.
    PhotonLimits limits() const;
    /// Between passes: saves what is planned and what that rests on, or restores it into a new
    /// schedule with the same settings.
    void state(StateArchive& archive);
    /// Saves for another render with as many eye paths what this one would go on with, or takes it
    /// before the first pass: the number is chosen by then, and a guide has learned. Where
    /// this or any part before it is taken, another render has taught, and first passes count less.
    void learned(LearnedParts& parts);
    /// Before the first pass: so many photon paths have told the guide where to start. They count
    /// as shot, and the guide's first passes have fewer.
    void explored(std::uint64_t paths);
    /// Takes the settings and state of a new schedule, but what another render has taught.
    void begin_anew(const PhotonSchedule& fresh);

  private:
    void set_taught(bool taught);
    void plan();
    /// Photon paths that cost as much as a pass's eye paths; 0 if that is not known.
    double even_paths() const;
    /// What photons should cost over what the eye does.
    double best_ratio() const;
    std::uint32_t best_paths() const;

    std::uint64_t seed_;
    bool adapts_, learns_, may_take_turns_;
    std::uint32_t eye_paths_;
    std::uint32_t paths_;  // of a pass that shoots
    PhotonTurns turns_;
    double chosen_weight_;  // of passes after the first choice
    std::uint64_t pass_ = 0;
    std::uint64_t decide_at_;  // pass before which the number is chosen next
    bool decided_ = false;
    bool planned_ = false;  // elsewhere
    bool taught_ = false;   // by another render
    PassPhotons next_;      // `known` of it is that of all passes
    // Since the last choice; at first, of the second half of all passes.
    PassWork work_;
    PassNoise noise_;
    std::uint64_t shot_ = 0;
};

}  // namespace aips
