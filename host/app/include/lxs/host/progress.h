// Shows how far a render is: a live line on a terminal, log lines now and then elsewhere.
#pragma once

#include <cstdint>
#include <string>

#include "lxs/host/budget.h"
#include "lxs/host/console_log.h"
#include "lxs/host/error_watch.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// What a render has done so far.
struct RenderTotals {
    std::uint64_t passes = 0;
    std::uint64_t photon_paths = 0;
    std::uint64_t rays = 0;
    double samples_per_pixel = 0;
    double seconds = 0;      ///< wall time of the passes
    double cpu_seconds = 0;  ///< of all threads in the passes

    void state(StateArchive& archive);
};

/// "1:02:03" or "2:03".
std::string clock_text(double seconds);
/// One line: passes, time gone, time left where it is known, and what there is to say of the error.
std::string progress_text(const RenderTotals& totals, const Budget& budget,
                          const std::string& error = {});
/// Photons and rays a second, memory.
std::string speed_text(const RenderTotals& totals, std::uint64_t resident_bytes);
/// One line at the end: passes, time, and why no more: `interruption`, unless that is empty.
std::string ending_text(const RenderTotals& totals, const Budget& budget,
                        const std::string& interruption);

class Progress {
  public:
    /// `verbose`: with speed and memory.
    Progress(ConsoleLog& log, const Budget& budget, ErrorWatch& error, bool verbose)
        : log_(log), budget_(budget), error_(error), verbose_(verbose) {}
    /// Before the first pass, which may take long.
    void begin(const RenderTotals& totals);
    /// After a pass; silent after the last one.
    void show(const RenderTotals& totals);
    /// Takes the live line away and logs how the render ended: by `interruption`, unless empty.
    void finish(const RenderTotals& totals, const std::string& interruption);

  private:
    ConsoleLog& log_;
    const Budget& budget_;
    ErrorWatch& error_;
    bool verbose_;
    double next_line_seconds_ = 0;
};

}  // namespace lxs
