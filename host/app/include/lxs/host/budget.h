// When a render ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lxs/host/command_line.h"
#include "lxs/imaging/imaging.h"
#include "lxs/sdk/log.h"

namespace lxs {

/// Passes rendered when neither the command line nor the scene says when to stop.
inline constexpr std::uint64_t kDefaultPasses = 16;

/// A render ends when any of its budgets is used up; checked between passes.
struct Budget {
    std::optional<std::uint64_t> passes;
    std::optional<double> seconds;
    /// Estimated, square root of relMSE; ErrorWatch knows when it is reached.
    std::optional<double> error = {};
    /// Who asked for them.
    std::string passes_from = "--passes", seconds_from = "--time", error_from = "--target-error";

    bool used_up(std::uint64_t passes_done, double seconds_gone) const;
    /// Seconds left at the speed so far; nothing before the first pass.
    std::optional<double> remaining(std::uint64_t passes_done, double seconds_gone) const;
    /// "16 passes or 60 s".
    std::string text() const;
    /// Which of them is used up; empty if none is.
    std::string why_over(std::uint64_t passes_done, double seconds_gone) const;
};

/// The command line's budget, else the film's haltspp, halttime and haltthreshold, else
/// kDefaultPasses (and says so).
Budget choose_budget(const CommandLine& command, const FileFilm& film, Log& log);

}  // namespace lxs
