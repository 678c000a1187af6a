// Photons from random primary coordinates, in full resolution.
#pragma once

#include "aips/adapter/scene.h"
#include "aips/core/sampling/random.h"

namespace aips {

inline bool emit_at_random(const Light& light, RandomStream& random, Emission& emission) {
    std::array<std::uint32_t, 4> bits{};
    for (std::uint32_t& b : bits)
        b = random.next_uint();
    return light.emit(primary_point(bits), emission);
}

}  // namespace aips
