// When snapshots are due: after the pass in which a clock passes a mark.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace bench {

/// A time on one of the two clocks.
struct TimeMark {
    std::string clock;  ///< "cpu" or "wall"
    double seconds = 0;
};

class TimeMarks {
  public:
    /// Half the smallest budget, so that errors can be interpolated up to it, and every budget, on
    /// both clocks or on the one that `clock` names.
    TimeMarks(std::span<const double> budgets_s, const std::string& clock);

    /// Marks passed since the last call.
    std::vector<TimeMark> due(double cpu_s, double wall_s);
    bool all_passed() const { return pending_.empty(); }

  private:
    std::vector<TimeMark> pending_;
};

}  // namespace bench
