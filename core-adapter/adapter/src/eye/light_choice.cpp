// Light choice by power.
#include "eye/light_choice.h"

#include <vector>

namespace aips {

bool emits(const Light& light) {
    const float power = light.power();
    return std::isfinite(power) && power > 0;
}

DiscreteDistribution light_choice(const Scene& scene) {
    std::vector<float> powers;
    powers.reserve(scene.lights().size());
    for (const Light* light : scene.lights()) {
        powers.push_back(emits(*light) ? light->power() : 0.0f);
    }
    return DiscreteDistribution(powers);
}

}  // namespace aips
