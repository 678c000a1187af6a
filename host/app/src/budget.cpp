// When a render ends.
#include "lxs/host/budget.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "lxs/host/counted.h"

namespace lxs {

bool Budget::used_up(std::uint64_t passes_done, double seconds_gone) const {
    return (passes && passes_done >= *passes) || (seconds && seconds_gone >= *seconds);
}

std::optional<double> Budget::remaining(std::uint64_t passes_done, double seconds_gone) const {
    std::optional<double> left;
    if (seconds) left = std::max(0.0, *seconds - seconds_gone);
    if (passes && passes_done > 0) {
        const double pass_seconds = seconds_gone / static_cast<double>(passes_done);
        const auto passes_left = *passes - std::min(*passes, passes_done);
        const double by_passes = pass_seconds * static_cast<double>(passes_left);
        left = std::min(left.value_or(by_passes), by_passes);
    }
    return left;
}

std::string Budget::text() const {
    std::vector<std::string> ends;
    if (passes) ends.push_back(counted(*passes, "pass", "passes"));
    if (seconds) ends.push_back(fmt::format("{} s", *seconds));
    if (error) ends.push_back(fmt::format("until the error is {:.3g} %", 100 * *error));
    return fmt::format("{}", fmt::join(ends, " or "));
}

std::string Budget::why_over(std::uint64_t passes_done, double seconds_gone) const {
    if (passes && passes_done >= *passes) {
        return fmt::format("{} {} asks for", passes_done > *passes ? "more than" : "as many as",
                           passes_from);
    }
    if (seconds && seconds_gone >= *seconds)
        return fmt::format("the {} s that {} gives are over", *seconds, seconds_from);
    return {};
}

Budget choose_budget(const CommandLine& command, const FileFilm& film, Log& log) {
    Budget budget{
        .passes = command.passes, .seconds = command.seconds, .error = command.target_error};
    const auto given = [&budget] { return budget.passes || budget.seconds || budget.error; };
    if (given()) return budget;
    budget.passes_from = "the scene's haltspp";
    budget.seconds_from = "the scene's halttime";
    budget.error_from = "the scene's haltthreshold";
    if (film.halt_passes() > 0) budget.passes = film.halt_passes();
    if (film.halt_time_seconds() > 0) budget.seconds = film.halt_time_seconds();
    if (film.halt_error() > 0) {
        if (command.error_estimate) {
            budget.error = film.halt_error();
        } else {
            log.warning("haltthreshold has no effect with --no-error-estimate");
        }
    }
    if (given()) return budget;
    log.info(fmt::format(
        "neither the scene (haltspp, halttime, haltthreshold) nor the command line (--passes, "
        "--time, --target-error) says when to stop: rendering {} passes",
        kDefaultPasses));
    budget.passes = kDefaultPasses;
    budget.passes_from = "the default";
    return budget;
}

}  // namespace lxs
