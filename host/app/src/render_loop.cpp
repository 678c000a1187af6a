// Pass after pass until a budget is used up or the user interrupts.
#include "lxs/host/render_loop.h"

#include <chrono>

#include "lxs/host/process_usage.h"
#include "lxs/host/seconds_since.h"

namespace lxs {

void RenderLoop::render_next(RenderTotals& totals) const {
    const auto start = std::chrono::steady_clock::now();
    const double cpu_start = cpu_seconds();
    if (begin_pass) begin_pass();
    const PassReport report = render_pass(session, totals.passes);
    ++totals.passes;
    totals.photon_paths += report.photon_paths;
    totals.rays += report.rays;
    totals.samples_per_pixel += report.samples_per_pixel;
    error.pass_done(totals);
    totals.seconds += seconds_since(start);
    totals.cpu_seconds += cpu_seconds() - cpu_start;
}

void RenderLoop::run(RenderTotals& totals) {
    progress.begin(totals);
    bool between = false;
    error.begin(totals);
    // At least one pass, however small the budget: without one there is no image.
    while (!interruption.requested() && !error.reached() &&
           (totals.passes == 0 || !budget.used_up(totals.passes, totals.seconds))) {
        if (between && between_passes) between_passes(totals);
        if (interruption.requested()) break;  // while the render was paused
        between = true;
        render_next(totals);
        progress.show(totals);
        if (end_pass) end_pass(totals);
    }
    progress.finish(totals, interruption.reason());
}

}  // namespace lxs
