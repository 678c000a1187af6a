// Bytes to values.
#include "input_bytes.h"

#include <array>
#include <bit>
#include <cmath>

namespace fuzz {
namespace {

constexpr std::array kEdges = {0.0,
                               1.0,
                               -1.0,
                               0.5,
                               2.0,
                               1e-6,
                               1e-30,
                               1e-45,
                               1e6,
                               1e9,
                               1e18,
                               1e30,
                               3.4e38,
                               -3.4e38,
                               -1e-45,
                               127.0,
                               128.0,
                               255.0,
                               256.0,
                               65535.0,
                               65536.0,
                               2147483647.0,
                               2147483648.0,
                               -2147483648.0,
                               4294967295.0,
                               4294967296.0,
                               9007199254740992.0,
                               -9007199254740992.0,
                               9.3e18,
                               0.99999,
                               1.00001,
                               90.0,
                               180.0,
                               360.0};

}  // namespace

std::uint8_t InputBytes::byte() {
    if (at_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(at_.front());
    at_.remove_prefix(1);
    return value;
}

std::size_t InputBytes::below(std::size_t n) {
    std::size_t value = byte();
    if (n > 256) value = value << 8 | byte();
    return value % n;
}

double InputBytes::number() {
    const std::uint8_t kind = byte();
    if (kind < kEdges.size()) return kEdges[kind];
    if (kind < 200) return (static_cast<double>(kind) - 100) / 8;
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i)
        bits = bits << 8 | byte();
    const auto value = static_cast<double>(std::bit_cast<float>(bits));
    return std::isfinite(value) ? value : 0;
}

std::string InputBytes::text(std::size_t most) {
    const std::size_t wanted = below(most + 1);  // before what is left is looked at
    const std::size_t length = std::min(wanted, at_.size());
    std::string value(at_.substr(0, length));
    at_.remove_prefix(length);
    return value;
}

}  // namespace fuzz
