// Pass after pass until a budget is used up or the user interrupts.
#pragma once

#include <functional>

#include "lxs/host/budget.h"
#include "lxs/host/error_watch.h"
#include "lxs/host/interruption.h"
#include "lxs/host/progress.h"
#include "lxs/sdk/integrator.h"

namespace lxs {

struct RenderLoop {
    Integrator& integrator;
    const Budget& budget;
    const Interruption& interruption;
    Progress& progress;
    ErrorWatch& error;
    std::function<void(std::uint64_t pass)> begin_pass = {};  ///< called before each; may be empty
    std::function<void(const RenderTotals&)> end_pass = {};   ///< called after each; may be empty
    double snapshot_interval = 0;  ///< seconds between snapshots; 0: none
    std::function<void(const RenderTotals&)> write_snapshot;  ///< does not throw

    /// Renders on from `totals`: none, or those of a render that is resumed. They are of all passes
    /// done, also where a pass ends with an exception.
    void run(RenderTotals& totals);
};

}  // namespace lxs
