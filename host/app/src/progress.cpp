// Shows how far a render is: a live line on a terminal, log lines now and then elsewhere.
#include "lxs/host/progress.h"

#include <fmt/format.h>

#include <cmath>

#include "lxs/host/counted.h"
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
                          const std::string& error) {
    std::string text = fmt::format("pass {}", totals.passes);
    if (budget.passes) text += fmt::format(" of {}", *budget.passes);
    text += fmt::format(", {} gone", clock_text(totals.seconds));
    if (const auto left = budget.remaining(totals.passes, totals.seconds))
        text += fmt::format(", about {} left", clock_text(*left));
    if (!error.empty()) text += ", " + error;
    return text;
}

std::string speed_text(const RenderTotals& totals, std::uint64_t resident_bytes) {
    std::string text;
    if (totals.photon_paths > 0)
        text = fmt::format("{} photons/s, ", rate_text(totals.photon_paths, totals.seconds));
    return text + fmt::format("{} rays/s, memory {} MB", rate_text(totals.rays, totals.seconds),
                              resident_bytes / 1'000'000);
}

std::string ending_text(const RenderTotals& totals, const Budget& budget,
                        const std::string& interruption) {
    std::string why =
        interruption.empty() ? budget.why_over(totals.passes, totals.seconds) : interruption;
    // The loop ends for nothing else.
    if (why.empty() && budget.error)
        why = fmt::format("the error of {:.3g} % that {} asks for is reached", 100 * *budget.error,
                          budget.error_from);
    return fmt::format("rendered {} in {}: {}", counted(totals.passes, "pass", "passes"),
                       clock_text(totals.seconds), why);
}

void Progress::begin(const RenderTotals& totals) {
    if (totals.passes == 0) log_.show_live("the first pass is being rendered");
}

void Progress::show(const RenderTotals& totals) {
    // finish() has the word
    if (error_.reached() || budget_.used_up(totals.passes, totals.seconds)) return;
    if (!log_.live() && totals.seconds < next_line_seconds_) return;
    std::string text = progress_text(totals, budget_, error_.text(totals));
    if (verbose_) text += ", " + speed_text(totals, resident_bytes());
    if (log_.live()) {
        log_.show_live(text);
    } else {
        log_.info(text);
        next_line_seconds_ = totals.seconds + kSecondsBetweenLogLines;
    }
}

void Progress::finish(const RenderTotals& totals, const std::string& interruption) {
    log_.clear_live();
    if (totals.passes == 0) return;
    std::string text = ending_text(totals, budget_, interruption);
    if (const std::string error = error_.ending_text(totals); !error.empty()) text += "; " + error;
    log_.info(text);
    log_.debug(speed_text(totals, resident_bytes()));
}

}  // namespace lxs
