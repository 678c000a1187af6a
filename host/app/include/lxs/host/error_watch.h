// Asks the film for the error of the image so far: for the progress, and for when to stop.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lxs/imaging/imaging.h"

namespace lxs {

struct RenderTotals;

/// The first number of passes, at least `passes`, after which the error is held against its target:
/// 8, and whenever the passes have grown by an eighth. So where a render stops depends on neither
/// time nor breaks.
std::uint64_t next_comparison(std::uint64_t passes);

class ErrorWatch {
  public:
    /// `target`: as ErrorEstimate::relative(); none: never reached.
    ErrorWatch(FileFilm& film, std::optional<double> target) : film_(film), target_(target) {}

    /// To be called after each pass.
    void pass_done(const RenderTotals& totals);
    /// To be called before the first pass: a render that is resumed may have reached its target.
    void begin(const RenderTotals& totals) { compare(totals); }
    bool reached() const { return reached_; }

    /// "error 8.3 %, 5 % in about 3:20", as of now or not long ago; empty if there is no estimate.
    /// Takes at most a hundredth of the render's time.
    std::string text(const RenderTotals& totals);
    /// The same as a figure; nothing if there is no estimate.
    std::optional<ErrorEstimate> recent(const RenderTotals& totals);
    std::optional<double> target() const { return target_; }
    /// "the estimated error is 8.3 %", as of now; empty if there is no estimate.
    std::string ending_text(const RenderTotals& totals);

  private:
    void compare(const RenderTotals& totals);
    void estimate(const RenderTotals& totals);
    bool stale(const RenderTotals& totals) const;
    double seconds_left(const RenderTotals& totals) const;

    FileFilm& film_;
    std::optional<double> target_;
    bool reached_ = false;
    std::optional<ErrorEstimate> latest_;
    double next_seconds_ = 0;  ///< of the totals, from which another estimate is due
};

}  // namespace lxs
