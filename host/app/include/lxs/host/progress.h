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

/// One line: pass, photons/s, rays/s, elapsed, remaining, what there is to say of the error,
/// resident memory.
std::string progress_text(const RenderTotals& totals, const Budget& budget,
                          std::uint64_t resident_bytes, const std::string& error = {});

class Progress {
  public:
    Progress(ConsoleLog& log, const Budget& budget, ErrorWatch& error)
        : log_(log), budget_(budget), error_(error) {}
    void show(const RenderTotals& totals);
    /// Takes the live line away and logs the last state.
    void finish(const RenderTotals& totals);

  private:
    ConsoleLog& log_;
    const Budget& budget_;
    ErrorWatch& error_;
    double next_line_seconds_ = 0;
};

}  // namespace lxs
