// Pass after pass until a budget is used up or the user interrupts.
#include "lxs/host/render_loop.h"

#include <chrono>

#include "lxs/host/process_usage.h"

namespace lxs {

void RenderLoop::run(RenderTotals& totals) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds_gone = [&, before = totals.seconds] {
        return before + std::chrono::duration<double>(Clock::now() - start).count();
    };
    const double cpu_start = cpu_seconds() - totals.cpu_seconds;
    double last_snapshot = totals.seconds;
    // At least one pass, however small the budget: without one there is no image.
    error.begin(totals);
    while (!interruption.requested() && !error.reached() &&
           (totals.passes == 0 || !budget.used_up(totals.passes, totals.seconds))) {
        if (snapshot_interval > 0 && totals.seconds - last_snapshot >= snapshot_interval) {
            write_snapshot(totals);
            last_snapshot = seconds_gone();
        }
        if (begin_pass) begin_pass(totals.passes);
        const PassReport report = integrator.render_pass(totals.passes);
        ++totals.passes;
        totals.photon_paths += report.photon_paths;
        totals.rays += report.rays;
        totals.samples_per_pixel += report.samples_per_pixel;
        totals.seconds = seconds_gone();
        totals.cpu_seconds = cpu_seconds() - cpu_start;
        error.pass_done(totals);
        progress.show(totals);
        if (end_pass) end_pass(totals);
    }
    progress.finish(totals);
}

}  // namespace lxs
