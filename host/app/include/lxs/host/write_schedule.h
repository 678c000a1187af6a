// When a file that shows the image so far is written while a render goes on.
#pragma once

#include <cstdint>
#include <optional>

namespace lxs {

/// Whether a file is written as often as it was asked to be, or less often where writing takes
/// long.
enum class WriteCost : std::uint8_t { Whatever, Bounded };

/// Of one file. Seconds are those of the passes, which stand still while files are written.
class WriteSchedule {
  public:
    /// The first is due at once, further ones whenever `interval` seconds have gone by; 0: none is.
    WriteSchedule(double interval, WriteCost cost) : interval_(interval), cost_(cost) {}

    /// Whether to write now, between two passes. `left`: seconds to the end, where known. With a
    /// bounded cost writing takes at most 1 % of the time, the first aside, and none begins where
    /// the last one is about to come.
    bool due(double seconds, std::optional<double> left) const;
    /// It was written, or could not be, in `took` seconds.
    void written(double seconds, double took);

    double interval() const { return interval_; }

  private:
    double interval_;
    WriteCost cost_;
    std::optional<double> last_;  ///< when it was written last; none: not yet
    double took_last_ = 0;
    double took_ = 0;  ///< all of them
};

}  // namespace lxs
