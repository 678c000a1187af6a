// Chooses which lights a path vertex asks for direct light.
#include "path/light_selector.h"

#include <cmath>

#include "lxs/sdk/quantized_cdf.h"

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
    std::vector<double> weights;
    for (const Light* light : lights) {
        if (light->at_infinity()) at_infinity_.push_back(light);
        const double weight = choice_weight(*light, strategy);
        if (!(weight > 0)) continue;
        weights.push_back(weight);
        lights_.push_back({light, 1});
    }
    // What is stated is what is drawn, for a light of a billionth of the power too.
    cumulative_.resize(weights.size() + 1);
    quantize_cdf(std::span<const double>(weights), std::span(cumulative_));
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (!all_) lights_[i].probability = cumulative_[i + 1] - cumulative_[i];
        probability_.emplace(lights_[i].light, lights_[i].probability);
    }
}

LightChoice LightSelector::choose(std::size_t i, float u) const {
    return lights_[all_ ? i : find_step(cumulative_, double(u))];
}

float LightSelector::probability(const Light* light) const {
    const auto found = probability_.find(light);
    return found == probability_.end() ? 0.0f : found->second;
}

}  // namespace lxs
