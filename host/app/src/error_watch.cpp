// Asks the film for the error of the image so far: for the progress, and for when to stop.
#include "lxs/host/error_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lxs/host/progress.h"

namespace lxs {
namespace {

constexpr std::uint64_t kFirstComparison = 8;  // passes
constexpr double kDearest = 0.01;              // share of the time that estimates may take
constexpr double kSecondsBetweenEstimates = 1;

}  // namespace

std::uint64_t next_comparison(std::uint64_t passes) {
    std::uint64_t at = kFirstComparison;
    while (at < passes)
        at += at / 8;
    return at;
}

void ErrorWatch::pass_done(const RenderTotals& totals) {
    film_.end_pass();
    compare(totals);
}

void ErrorWatch::compare(const RenderTotals& totals) {
    if (!target_ || next_comparison(totals.passes) != totals.passes) return;
    estimate(totals);
    reached_ = latest_ && latest_->relative() <= *target_;
}

void ErrorWatch::estimate(const RenderTotals& totals) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    latest_ = film_.error();
    const double took = std::chrono::duration<double>(Clock::now() - start).count();
    next_seconds_ = totals.seconds + std::max(kSecondsBetweenEstimates, took / kDearest);
}

bool ErrorWatch::stale(const RenderTotals& totals) const {
    return !latest_ || latest_->passes != totals.passes;
}

std::optional<ErrorEstimate> ErrorWatch::recent(const RenderTotals& totals) {
    if (stale(totals) && totals.seconds >= next_seconds_) estimate(totals);
    return latest_;
}

std::string ErrorWatch::text(const RenderTotals& totals) {
    if (!recent(totals)) return {};
    std::string text = fmt::format("error {:.3g} %", 100 * latest_->relative());
    if (target_)
        text +=
            fmt::format(", {:.3g} % in about {}", 100 * *target_, clock_text(seconds_left(totals)));
    return text;
}

/// What chance is to blame for falls with the passes' number, and with it the squared error. The
/// render ends at a comparison, not before.
double ErrorWatch::seconds_left(const RenderTotals& totals) const {
    constexpr double kMostPasses = 1e15;  // numbers that clock_text can write
    const double times = latest_->relative() / *target_;
    const double needed = times * times * static_cast<double>(latest_->passes);
    const auto done = static_cast<double>(totals.passes);
    const auto last = next_comparison(
        static_cast<std::uint64_t>(std::clamp(std::ceil(needed), done + 1, kMostPasses)));
    return totals.seconds * (static_cast<double>(last) / done - 1);
}

std::string ErrorWatch::ending_text(const RenderTotals& totals) {
    if (stale(totals)) estimate(totals);
    if (!latest_) return {};
    return fmt::format("the estimated error is {:.3g} %", 100 * latest_->relative());
}

}  // namespace lxs
