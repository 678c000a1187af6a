// Asks the film for the error of the image so far: for the progress, and for when to stop.
#include "lxs/host/error_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "lxs/host/progress.h"

namespace lxs {
namespace {

constexpr std::uint64_t kFirstComparison = 8;  // passes
constexpr double kDearest = 0.01;              // share of the time that estimates may take
constexpr double kSecondsBetweenEstimates = 1;

}  // namespace

bool compares_error_after(std::uint64_t passes) {
    std::uint64_t at = kFirstComparison;
    while (at < passes)
        at += at / 8;
    return at == passes;
}

void ErrorWatch::pass_done(const RenderTotals& totals) {
    film_.end_pass();
    compare(totals);
}

void ErrorWatch::compare(const RenderTotals& totals) {
    if (!target_ || !compares_error_after(totals.passes)) return;
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

std::string ErrorWatch::text(const RenderTotals& totals) {
    if (stale(totals) && totals.seconds >= next_seconds_) estimate(totals);
    if (!latest_) return {};
    const double error = latest_->relative();
    std::string text = fmt::format("error {:.3g} %", 100 * error);
    if (!target_) return text;
    text += fmt::format(", {:.3g} % ", 100 * *target_);
    if (error <= *target_) return text + "is reached";
    // What chance is to blame for falls with the passes' number, and with it the squared error.
    const double times = error / *target_ * (error / *target_);
    const double passes = times * static_cast<double>(latest_->passes);
    const double left = totals.seconds * (passes / static_cast<double>(totals.passes) - 1);
    return text + "in " + clock_text(std::max(0.0, left));
}

std::string ErrorWatch::ending_text(const RenderTotals& totals) {
    if (stale(totals)) estimate(totals);
    if (!latest_) return {};
    return fmt::format("the estimated error is {:.3g} %", 100 * latest_->relative());
}

}  // namespace lxs
