// Numbers as scene files write them.
#pragma once

#include <optional>
#include <string_view>

namespace lxs {

/// Whatever the locale.
inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Value of a decimal number (sign, digits, point, exponent), whatever the locale says; what is too
/// small for a double becomes 0. Nothing if it is beyond single precision, the renderer's own
/// (3.4e38): it would become infinite there.
std::optional<double> parse_number(std::string_view text);

}  // namespace lxs
