// Light choice by power.
#include "light_choice.h"

#include <vector>

namespace aips {

DiscreteDistribution light_choice(const Scene& scene) {
    std::vector<float> powers;
    powers.reserve(scene.lights().size());
    for (const Light* light : scene.lights()) {
        const float power = light->power();
        powers.push_back(std::isfinite(power) && power > 0 ? power : 0.0f);
    }
    return DiscreteDistribution(powers);
}

}  // namespace aips
