// A hash of 32 bits.
#pragma once

#include <cstdint>

namespace lxs::shading {

/// 32 bits mixed well, one to one (Wellons 2018, "Prospecting for hash functions", lowbias32).
constexpr std::uint32_t hashed(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

}  // namespace lxs::shading
