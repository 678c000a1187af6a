// Shows how far a render is: a live line on a terminal, log lines now and then elsewhere.
#include "lxs/host/progress.h"

#include <fmt/format.h>

#include <cmath>

#include "lxs/host/process_usage.h"

namespace lxs {
namespace {

constexpr double kSecondsBetweenLogLines = 10;

std::string rate_text(std::uint64_t count, double seconds) {
    const double rate = seconds > 0 ? static_cast<double>(count) / seconds : 0;
    return rate < 1e6 ? fmt::format("{:.1f} k", rate * 1e-3) : fmt::format("{:.2f} M", rate * 1e-6);
}

}  // namespace

std::string clock_text(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::lround(seconds));
    const std::uint64_t hours = whole / 3600;
    const std::uint64_t minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

void RenderTotals::state(StateArchive& archive) {
    for (std::uint64_t* count : {&passes, &photon_paths, &rays})
        archive.value(*count);
    for (double* figure : {&samples_per_pixel, &seconds, &cpu_seconds})
        archive.value(*figure);
    if (!(seconds >= 0) || !(cpu_seconds >= 0) || !std::isfinite(seconds + cpu_seconds))
        throw StateError("the time that it took is no possible one");
}

std::string progress_text(const RenderTotals& totals, const Budget& budget,
                          std::uint64_t resident_bytes, const std::string& error) {
    std::string text = fmt::format("pass {}", totals.passes);
    if (budget.passes) text += fmt::format("/{}", *budget.passes);
    if (totals.photon_paths > 0) {
        text += fmt::format("  {} photons/s", rate_text(totals.photon_paths, totals.seconds));
    }
    text += fmt::format("  {} rays/s  elapsed {}", rate_text(totals.rays, totals.seconds),
                        clock_text(totals.seconds));
    if (const auto left = budget.remaining(totals.passes, totals.seconds)) {
        text += fmt::format("  remaining {}", clock_text(*left));
    }
    if (!error.empty()) text += "  " + error;
    return text + fmt::format("  memory {} MB", resident_bytes / 1'000'000);
}

void Progress::show(const RenderTotals& totals) {
    if (!log_.live() && totals.seconds < next_line_seconds_) return;
    const std::string text = progress_text(totals, budget_, resident_bytes(), error_.text(totals));
    if (log_.live()) {
        log_.show_live(text);
    } else {
        log_.info(text);
        next_line_seconds_ = totals.seconds + kSecondsBetweenLogLines;
    }
}

void Progress::finish(const RenderTotals& totals) {
    log_.clear_live();
    log_.info("rendered " + progress_text(totals, {}, resident_bytes(), error_.text(totals, true)));
}

}  // namespace lxs
