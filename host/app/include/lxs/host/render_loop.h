// Pass after pass until a budget is used up or the user interrupts.
#pragma once

#include <functional>

#include "lxs/host/budget.h"
#include "lxs/host/error_watch.h"
#include "lxs/host/interruption.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

struct RenderLoop {
    RenderSession& session;
    const Budget& budget;
    const Interruption& interruption;
    Progress& progress;
    ErrorWatch& error;
    std::function<void()> begin_pass = {};                   ///< called before each; may be empty
    std::function<void(const RenderTotals&)> end_pass = {};  ///< called after each; may be empty
    /// Called after each but the last; may be empty.
    std::function<void(const RenderTotals&)> between_passes = {};

    /// Renders on from `totals`: none, or those of a render that is resumed. They are of all passes
    /// done, also where a pass ends with an exception. Clocks run in the passes alone: what is
    /// written after them costs a render by time no pass.
    void run(RenderTotals& totals);

  private:
    void render_next(RenderTotals& totals) const;
};

}  // namespace lxs
