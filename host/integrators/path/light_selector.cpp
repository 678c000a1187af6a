// Chooses which lights a path vertex asks for direct light.
#include "path/light_selector.h"

#include <cmath>

#include "lxs/sdk/quantized_cdf.h"
#include "path/core_archive.h"

namespace lxs {
namespace {

/// Most lights that tables are made of: as many as aips::DiscreteDistribution takes.
constexpr std::size_t kMostLearned = std::size_t{1} << 22;

aips::Vec3 core_vector(const Vec3& v) {
    return {v.x, v.y, v.z};
}

double choice_weight(const Light& light, LightStrategy strategy) {
    const double power = light.power();
    if (!(power > 0) || !std::isfinite(power)) return 0;
    switch (strategy) {
        case LightStrategy::Learned:
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

LightSelector::LightSelector(std::span<const Light* const> lights, LightStrategy strategy,
                             const Bounds& scene)
    : all_(strategy == LightStrategy::All) {
    std::vector<double> weights;
    for (const Light* light : lights) {
        if (light->at_infinity()) at_infinity_.push_back(light);
        const double weight = choice_weight(*light, strategy);
        if (!(weight > 0)) continue;
        weights.push_back(weight);
        index_of_.emplace(light, static_cast<std::uint32_t>(lights_.size()));
        lights_.push_back({light, 1, static_cast<std::uint32_t>(lights_.size())});
    }
    // What is stated is what is drawn, for a light of a billionth of the power too.
    cumulative_.resize(weights.size() + 1);
    quantize_cdf(std::span<const double>(weights), std::span(cumulative_));
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (!all_) lights_[i].probability = cumulative_[i + 1] - cumulative_[i];
    }
    if (strategy == LightStrategy::Learned && lights_.size() > 1 &&
        lights_.size() <= kMostLearned) {
        const std::vector<float> plain(weights.begin(), weights.end());
        learned_.emplace(aips::Bounds{core_vector(scene.min), core_vector(scene.max)},
                         aips::DiscreteDistribution(plain));
    }
}

LightTable LightSelector::at(const Vec3& p, const Vec3& n) const {
    return learned_ ? &learned_->at(core_vector(p), core_vector(n)) : nullptr;
}

LightChoice LightSelector::choose(std::size_t i, float u, LightTable table) const {
    if (table) {
        const aips::DiscreteSample chosen = table->sample(u);
        const LightChoice& plain = lights_[chosen.index];
        return {plain.light, chosen.pdf, plain.index};
    }
    return lights_[all_ ? i : find_step(cumulative_, double(u))];
}

float LightSelector::probability(const Light* light, LightTable table) const {
    const auto found = index_of_.find(light);
    if (found == index_of_.end()) return 0.0f;
    return table ? table->pdf(found->second) : lights_[found->second].probability;
}

void LightSelector::learn(std::span<const aips::LightSample> samples, std::uint64_t due,
                          std::uint64_t passes) {
    if (learned_) learned_->learn(samples, due, passes);
}

void LightSelector::state(StateArchive& archive) {
    if (!learned_) return;
    CoreArchive core(archive);
    try {
        learned_->state(core);
    } catch (const aips::StateError& error) {
        throw StateError(error.what());
    }
}

void LightSelector::learned(StateArchive& archive) {
    CoreArchive core(archive);
    try {
        aips::LearnedParts parts(core);
        if (learned_) learned_->learned(parts);
        parts.end();
    } catch (const aips::StateError& error) {
        throw StateError(error.what());
    }
}

}  // namespace lxs
