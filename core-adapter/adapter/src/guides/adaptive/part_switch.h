// Disables a part of a guide that does not pay: it neither guides nor learns for a while.
//
// What learning and looking up cost is saved; that things have changed is found when it is tried
// again, whenever the photon paths have doubled.
#pragma once

#include <cstdint>

#include "aips/core/base/state_archive.h"
#include "guides/adaptive/constants.h"

namespace aips {

class PartSwitch {
  public:
    bool enabled() const { return enabled_; }
    /// Between passes, after `paths` photon paths in all; `pays`: as it was judged when last
    /// enabled.
    void update(std::uint64_t paths, bool pays) {
        if (paths < turn_at_ || (enabled_ && pays)) return;
        enabled_ = !enabled_;
        turn_at_ = enabled_ ? paths + kTrial / 2 : 2 * paths;
    }

    /// Saves or restores it.
    void state(StateArchive& archive) {
        archive.value(enabled_);
        archive.value(turn_at_);
    }

  private:
    /// Photon paths of the first trial; later ones go on from what was learned.
    static constexpr auto kTrial = static_cast<std::uint64_t>(kLearningPaths);

    bool enabled_ = true;
    std::uint64_t turn_at_ = kTrial;  // photon paths from which on it may change
};

}  // namespace aips
