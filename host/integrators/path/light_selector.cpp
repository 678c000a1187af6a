// Chooses which lights a path vertex asks for direct light.
#include "path/light_selector.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

double choice_weight(const Light& light, LightStrategy strategy) {
    const double power = light.power();
    if (!(power > 0) || !std::isfinite(power)) return 0;
    switch (strategy) {
        case LightStrategy::Power:
            return power;
        case LightStrategy::LogPower:
            return std::log1p(power);
        case LightStrategy::All:
        case LightStrategy::Uniform:
            break;
    }
    return 1;
}

}  // namespace

LightSelector::LightSelector(std::span<const Light* const> lights, LightStrategy strategy)
    : all_(strategy == LightStrategy::All) {
    double total = 0;
    for (const Light* light : lights) {
        if (light->at_infinity()) at_infinity_.push_back(light);
        const double weight = choice_weight(*light, strategy);
        if (!(weight > 0)) continue;
        total += weight;
        lights_.push_back({light, static_cast<float>(weight)});
        cumulative_.push_back(total);
    }
    for (double& value : cumulative_)
        value /= total;
    for (LightChoice& choice : lights_) {
        choice.probability = all_ ? 1.0f : static_cast<float>(choice.probability / total);
        probability_.emplace(choice.light, choice.probability);
    }
}

LightChoice LightSelector::choose(std::size_t i, float u) const {
    if (all_) return lights_[i];
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), double{u});
    const auto last = cumulative_.end() - 1;
    return lights_[static_cast<std::size_t>(std::min(found, last) - cumulative_.begin())];
}

float LightSelector::probability(const Light* light) const {
    const auto found = probability_.find(light);
    return found == probability_.end() ? 0.0f : found->second;
}

}  // namespace lxs
