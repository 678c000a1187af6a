// Ratio of two methods' errors with its spread over seeds.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace bench {

/// Confidence of the interval from `low` to `high`.
inline constexpr double kConfidence = 0.95;

/// exp of the mean log ratio over seeds, and of its t-interval.
struct ErrorRatio {
    std::optional<double> ratio;      ///< nothing if no seed has both errors
    std::optional<double> low, high;  ///< nothing with fewer than two seeds
    std::size_t used = 0;             ///< seeds
    std::size_t left_out = 0;         ///< seeds in which an error is missing or not positive
};

/// errors[i] and baseline[i] belong to the same seed; equally many.
ErrorRatio error_ratio(std::span<const std::optional<double>> errors,
                       std::span<const std::optional<double>> baseline);

}  // namespace bench
