// Decimal text to double.
#include "number.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lxs {
namespace {

/// Power of ten of the first digit that isn't zero: tells apart overflow and underflow, for which
/// std::from_chars has one and the same answer.
std::int64_t decimal_magnitude(std::string_view text) {
    const std::size_t exponent_mark = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, exponent_mark);
    std::int64_t exponent = 0;
    if (exponent_mark != std::string_view::npos) {
        std::string_view digits = text.substr(exponent_mark + 1);
        if (digits.front() == '+') digits.remove_prefix(1);
        const auto result = std::from_chars(digits.begin(), digits.end(), exponent);
        if (result.ec != std::errc()) exponent = digits.front() == '-' ? INT32_MIN : INT32_MAX;
    }
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    for (std::size_t i = 0; i < mantissa.size(); ++i) {
        if (!is_digit(mantissa[i]) || mantissa[i] == '0') continue;
        return exponent + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(i);
    }
    return std::numeric_limits<std::int64_t>::min();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto result = std::from_chars(text.begin(), text.end(), value);
    if (result.ec == std::errc::result_out_of_range) {
        if (decimal_magnitude(text) < 0) return 0.0;
        return std::nullopt;
    }
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (result.ec != std::errc() || std::abs(value) > kLargest) return std::nullopt;
    return value;
}

}  // namespace lxs
