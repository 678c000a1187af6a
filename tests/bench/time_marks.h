// When snapshots are due: after the pass in which a clock passes a mark, and after given passes.
#pragma once

#include <cstdint>
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
    /// both clocks or on the one that `clock` names. No budgets, no marks.
    TimeMarks(std::span<const double> budgets_s, const std::string& clock);

    /// Marks passed since the last call.
    std::vector<TimeMark> due(double cpu_s, double wall_s);
    bool all_passed() const { return pending_.empty(); }

  private:
    std::vector<TimeMark> pending_;
};

/// Numbers of passes after which snapshots are due.
class PassMarks {
  public:
    /// Ascending.
    explicit PassMarks(std::span<const std::uint64_t> passes)
        : pending_(passes.begin(), passes.end()) {}

    /// Whether a mark was reached since the last call.
    bool due(std::uint64_t passes);
    bool all_passed() const { return pending_.empty(); }

  private:
    std::vector<std::uint64_t> pending_;
};

}  // namespace bench
