// A mean of samples with a bound of its error that holds without a large-sample approximation.
// Source: Audibert, Munos & Szepesvari 2009, "Exploration-exploitation tradeoff using variance
// estimates in multi-armed bandits", theorem 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tolerances.h"

namespace aips {

/// Of numbers >= 0.
class Estimate {
  public:
    void add(double x) {
        ++count_;
        sum_ += x;
        sum_of_squares_ += x * x;
        largest_ = std::max(largest_, x);
    }
    std::uint64_t count() const { return count_; }
    double mean() const { return count_ ? sum_ / double(count_) : 0; }
    /// Exceeded with probability kErrorProbability at most by samples within [0, `range`]; where no
    /// range is known the largest sample has to do, and the bound is what samples show.
    double error(double range = 0) const {
        if (count_ < 2) return 1e300;
        const double n = double(count_), m = mean();
        const double variance = std::max(0.0, (sum_of_squares_ - n * m * m) / (n - 1));
        const double log_term = std::log(3 / kErrorProbability);
        return std::sqrt(2 * variance * log_term / n) +
               3 * std::max(range, largest_) * log_term / n;
    }
    /// Two estimates in each of 9 comparisons (all directions and octants) of each of four choices
    /// of lobes: the most that one subject is asked for.
    static constexpr double kErrorProbability = kChanceOfFinding / (2 * 9 * 4);

  private:
    std::uint64_t count_ = 0;
    double sum_ = 0, sum_of_squares_ = 0, largest_ = 0;
};

/// Whether two estimates of one number contradict each other by more than chance and more than
/// `tolerance`.
inline bool differ(const Estimate& a, const Estimate& b, double tolerance, double range = 0) {
    const double difference = std::abs(a.mean() - b.mean());
    return difference > tolerance && difference > a.error(range) + b.error(range);
}

}  // namespace aips
