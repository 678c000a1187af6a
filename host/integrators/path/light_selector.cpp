// Chooses which lights a path vertex asks for direct light.
#include "path/light_selector.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// From sums of weights to probabilities in steps of 2^-24, as random numbers are, one at least for
/// each light: what is stated is what is drawn, for a light of a billionth of the power too.
void quantize(std::vector<double>& sums) {
    constexpr double kSteps = 0x1p24;
    const auto count = static_cast<double>(sums.size());
    if (sums.empty()) return;
    const double total = sums.back();
    double set_aside = 0;
    for (double& sum : sums) {
        set_aside += 1;
        sum = (set_aside + std::floor(sum / total * (kSteps - count))) / kSteps;
    }
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
        lights_.push_back({light, 1});
        cumulative_.push_back(total);
    }
    quantize(cumulative_);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const double before = i == 0 ? 0 : cumulative_[i - 1];
        if (!all_) lights_[i].probability = static_cast<float>(cumulative_[i] - before);
        probability_.emplace(lights_[i].light, lights_[i].probability);
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
