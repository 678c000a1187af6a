// When a file that shows the image so far is written while a render goes on.
#include "lxs/host/write_schedule.h"

namespace lxs {
namespace {

/// Most of the time that writing a file takes: EXR and PNG together stay within 2 %.
constexpr double kMostOfTime = 0.01;
/// Seconds before the end from which on the finished image is waited for.
constexpr double kNearEnd = 1;

}  // namespace

bool WriteSchedule::due(double seconds, std::optional<double> left) const {
    if (!(interval_ > 0)) return false;
    const bool over = !last_ || seconds - *last_ >= interval_;
    if (!over || cost_ == WriteCost::Whatever) return over;
    if (left && *left < kNearEnd) return false;
    return !last_ || took_ + took_last_ <= kMostOfTime * seconds;
}

void WriteSchedule::written(double seconds, double took) {
    last_ = seconds;
    took_last_ = took;
    took_ += took;
}

}  // namespace lxs
