// The primary coordinates of Light::emit as this check draws them: the only place that knows their
// type.
#pragma once

#include "aips/adapter/scene.h"
#include "aips/core/random.h"

namespace aips {

using EmissionNumbers = std::array<float, 4>;

inline EmissionNumbers draw_emission_numbers(RandomStream& random) {
    EmissionNumbers u{};
    for (auto& x : u)
        x = random.next();
    return u;
}

inline bool emit_at_random(const Light& light, RandomStream& random, Emission& emission) {
    return light.emit(draw_emission_numbers(random), emission);
}

}  // namespace aips
