// Long lists of numbers, read without the grammar.
#include "number_run.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "number.h"

namespace lxs {
namespace {

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// The number at `at`, which ends before a blank or a closing bracket; null if there is none that
/// is sure to mean the same to the grammar.
const char* read_plain_number(const char* at, const char* end, double& value) {
    const char* p = at;
    std::int64_t integer = 0;
    constexpr int kMostDigits = 15;  // exact as a double
    while (p < end && is_digit(*p) && p - at <= kMostDigits)
        integer = 10 * integer + (*p++ - '0');
    if (p > at && p < end && (is_blank(*p) || *p == ']') && p - at <= kMostDigits) {
        value = static_cast<double>(integer);
        return p;
    }
    const char* digits = at < end && *at == '-' ? at + 1 : at;
    if (digits == end || !(is_digit(*digits) || *digits == '.')) return nullptr;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || read.ptr == end || !(is_blank(*read.ptr) || *read.ptr == ']'))
        return nullptr;
    constexpr double kLargest = std::numeric_limits<float>::max();
    return std::abs(value) <= kLargest ? read.ptr : nullptr;
}

}  // namespace

const char* read_number_run(const char* at, const char* end, std::vector<double>& values) {
    double value = 0;
    while (const char* behind = read_plain_number(at, end, value)) {
        values.push_back(value);
        for (at = behind; at < end && is_blank(*at);)
            ++at;
    }
    return at;
}

}  // namespace lxs
