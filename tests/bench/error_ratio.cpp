// Ratio of two methods' errors with its spread over seeds.
#include "error_ratio.h"

#include <cmath>
#include <vector>

#include "block_test.h"

namespace bench {

ErrorRatio error_ratio(std::span<const std::optional<double>> errors,
                       std::span<const std::optional<double>> baseline) {
    std::vector<double> logs;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (errors[i].value_or(0) > 0 && baseline[i].value_or(0) > 0) {
            logs.push_back(std::log(*errors[i] / *baseline[i]));
        }
    }
    ErrorRatio result;
    result.used = logs.size();
    result.left_out = errors.size() - logs.size();
    if (logs.empty()) return result;
    const auto count = double(logs.size());
    double mean = 0;
    for (const double value : logs)
        mean += value / count;
    result.ratio = std::exp(mean);
    if (logs.size() < 2) return result;
    double squares = 0;
    for (const double value : logs)
        squares += (value - mean) * (value - mean);
    const double half = statistics::student_interval(kConfidence, count - 1) *
                        std::sqrt(squares / (count - 1) / count);
    result.low = std::exp(mean - half);
    result.high = std::exp(mean + half);
    return result;
}

}  // namespace bench
