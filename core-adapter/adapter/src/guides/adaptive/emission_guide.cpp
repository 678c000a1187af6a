// Mixture of the plain, the seeds' and the learned density of emission.
#include "guides/adaptive/emission_guide.h"

#include "aips/core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace aips {
namespace {

/// What seeds found from the eye in another render count for.
constexpr double kRememberedSeeds = 1.0 / 16;

/// Of the trees of all lights: those that emit share the leaves, dead ones have one each.
std::vector<PrimaryTreeSettings> tree_settings(const DiscreteDistribution& plain_choice,
                                               const EmissionGuideSettings& s) {
    std::uint32_t alive = 0;
    for (std::size_t l = 0; l < plain_choice.size(); ++l)
        alive += plain_choice.pdf(l) > 0 ? 1 : 0;
    const std::uint32_t share = std::max(1u, s.max_leaves / std::max(1u, alive));
    std::vector<PrimaryTreeSettings> trees(plain_choice.size());
    for (std::size_t l = 0; l < trees.size(); ++l) {
        trees[l].max_leaves = plain_choice.pdf(l) > 0 ? share : 1;
        trees[l].memory_paths = s.memory_paths;
    }
    return trees;
}

}  // namespace

EmissionGuide::EmissionGuide(std::size_t lights, const DiscreteDistribution& plain_choice,
                             const EmissionGuideSettings& settings)
    : plain_choice_(&plain_choice), settings_(settings), seeds_(lights, 0.0) {
    trees_.reserve(lights);
    for (const PrimaryTreeSettings& tree : tree_settings(plain_choice, settings))
        trees_.emplace_back(tree);
}

EmissionStart EmissionGuide::sample(float u_light, const PrimaryPoint& u) const {
    EmissionStart start;
    if (!on_) {
        const DiscreteSample light = plain_choice_->sample(u_light);
        start.light = static_cast<LightIndex>(light.index);
        start.point = u;
        start.pdf = double(light.pdf);
        return start;
    }
    const DiscreteSample light = choice_.sample(u_light);
    start.light = static_cast<LightIndex>(light.index);
    const PrimarySample sample = trees_[light.index].sample(u);
    start.point = sample.point;
    start.pdf = double(light.pdf) * double(sample.pdf);
    return start;
}

double EmissionGuide::guided_pdf(const EmissionStart& start) const {
    return double(choice_.pdf(start.light)) * double(trees_[start.light].pdf(start.point));
}

void EmissionGuide::add(const EmissionScore& s) {
    if (!(s.start.pdf > 0) || s.start.light >= trees_.size()) return;
    if (!(s.score >= 0 && s.cost > 0) || !std::isfinite(s.score) || !std::isfinite(s.cost)) return;
    if (learned_) {
        moments_.add(s.score, s.cost, kLookUpCost, s.start.pdf, plain_pdf(s.start.light),
                     guided_pdf(s.start));
    }
    if (s.score > 0) ++scored_;
    trees_[s.start.light].add(s.start.point, s.score, s.cost);
}

void EmissionGuide::add_part(const EmissionStart& start, double part, double cost) {
    if (!(part > 0) || !std::isfinite(part) || start.light >= trees_.size()) return;
    ++scored_;
    trees_[start.light].add(start.point, part * part, cost);
}

/// Calls visit(light, seeds) for each light that emits, with its seeds.
template <class Visit>
void EmissionGuide::for_each_light(std::span<const EmissionSeed> seeds, const Visit& visit) const {
    while (!seeds.empty()) {
        const LightIndex light = seeds.front().light;
        const auto end = std::ranges::find_if_not(
            seeds, [light](const EmissionSeed& seed) { return seed.light == light; });
        const auto count = static_cast<std::size_t>(end - seeds.begin());
        if (light < trees_.size() && plain_pdf(light) > 0) visit(light, seeds.first(count));
        seeds = seeds.subspan(count);
    }
}

void EmissionGuide::focus(std::span<const EmissionSeed> starts) {
    for_each_light(starts, [&](LightIndex light, std::span<const EmissionSeed> of_light) {
        std::vector<PrimaryPoint> points;
        points.reserve(of_light.size());
        for (const EmissionSeed& start : of_light)
            points.push_back(start.point);
        trees_[light].focus(points);
    });
}

void EmissionGuide::add_seeds(std::span<const EmissionSeed> seeds) {
    focus(seeds);
    for_each_light(seeds, [&](LightIndex light, std::span<const EmissionSeed> of_light) {
        for (const EmissionSeed& seed : of_light) {
            trees_[light].add_seed(seed.point, double(seed.weight));
            seeds_[light] += double(seed.weight);
        }
    });
}

void EmissionGuide::update(double paths) {
    for (PrimaryTree& tree : trees_)
        tree.update(paths);
    set_densities();
    if (learned_) judge();
    moments_.fade(paths, settings_.memory_paths);
}

// p(l, x) = d P0(l) + s S_l seeds_l(x) + (1 - d - s) M_l learned_l(x), S and M normalised over
// lights. The sum over x gives the choice of the light, the rest the mixture within it.
void EmissionGuide::set_densities() {
    std::vector<double> masses;
    masses.reserve(trees_.size());
    for (const PrimaryTree& tree : trees_)
        masses.push_back(tree.mass());
    const double mass = std::accumulate(masses.begin(), masses.end(), 0.0);
    const double all_seeds = std::accumulate(seeds_.begin(), seeds_.end(), 0.0);
    // Masses beyond all numbers tell nothing.
    if (!std::isfinite(mass + all_seeds)) return;
    learned_ = mass > 0 || all_seeds > 0;
    if (!learned_) return;
    const bool enough = scored_ >= settings_.learned_scores;
    double seed_share = enough ? settings_.learned_seed_share : settings_.seed_share;
    double plain_share = settings_.plain_share;
    if (!(all_seeds > 0)) seed_share = 0;
    double learned_share = 1 - plain_share - seed_share;
    if (!(mass > 0)) {
        plain_share += learned_share;
        learned_share = 0;
    }
    std::vector<float> weights(trees_.size());
    for (std::size_t l = 0; l < trees_.size(); ++l) {
        const double plain = plain_share * plain_pdf(LightIndex(l));
        const double seeds = all_seeds > 0 ? seed_share * seeds_[l] / all_seeds : 0;
        const double learned = mass > 0 ? learned_share * masses[l] / mass : 0;
        const double sum = plain + seeds + learned;
        weights[l] = float(sum);
        if (sum > 0) trees_[l].set_mixture({plain / sum, seeds / sum});
    }
    choice_.build(weights);
}

void EmissionGuide::judge() {
    const bool tried =
        moments_.paths() >= settings_.trial_paths && scored_ >= settings_.learned_scores;
    on_ = !tried || moments_.gain() > kLeastGain;
}

// Densities are made from what was learned; lights that emit nothing have learned nothing.
void EmissionGuide::state(StateArchive& archive) {
    for (std::size_t l = 0; l < trees_.size(); ++l) {
        if (!(plain_pdf(LightIndex(l)) > 0)) continue;
        trees_[l].state(archive);
        archive.amount(seeds_[l]);
    }
    moments_.state(archive);
    archive.value(scored_);
    archive.value(on_);
    if (!archive.restoring()) return;
    set_densities();
    StateArchive::check(learned_ || !on_, "a guide of emission that is on and knows nothing");
}

void EmissionGuide::begin_anew(double paths) {
    for (PrimaryTree& tree : trees_)
        tree.fade(paths, kRememberedSeeds);
    for (double& weight : seeds_)
        weight *= kRememberedSeeds;
    moments_ = {};
    scored_ = std::min<std::uint64_t>(scored_, settings_.learned_scores);
    set_densities();
    on_ = learned_;
}

std::uint64_t EmissionGuide::fit() const {
    std::uint64_t lights = 0xCBF29CE484222325u ^ trees_.size();  // FNV-1a
    for (std::size_t l = 0; l < trees_.size(); ++l)
        lights = (lights ^ (plain_pdf(LightIndex(l)) > 0 ? 1 : 0)) * 0x100000001B3u;
    return lights;
}

double EmissionGuide::starved_share(double density) const {
    if (!on_) return 0;
    double sum = 0;
    for (std::size_t l = 0; l < trees_.size(); ++l) {
        const double plain = plain_pdf(LightIndex(l));
        // The light as a whole may be chosen more or less often than by power.
        if (plain > 0) sum += plain * trees_[l].volume_below(density * plain / choice_.pdf(l));
    }
    return sum;
}

std::size_t EmissionGuide::leaf_count() const {
    std::size_t sum = 0;
    for (const PrimaryTree& tree : trees_)
        sum += tree.leaf_count();
    return sum;
}

std::size_t EmissionGuide::memory_bytes() const {
    std::size_t bytes = trees_.size() * (sizeof(PrimaryTree) + sizeof(double) + sizeof(float));
    for (const PrimaryTree& tree : trees_)
        bytes += tree.memory_bytes();
    return bytes;
}

std::size_t EmissionGuide::memory_bound_bytes(const DiscreteDistribution& plain_choice,
                                              const EmissionGuideSettings& settings) {
    std::size_t bytes = 0;
    for (const PrimaryTreeSettings& tree : tree_settings(plain_choice, settings)) {
        bytes += sizeof(PrimaryTree) + sizeof(double) + sizeof(float) +
                 PrimaryTree::memory_bound_bytes(tree);
    }
    return bytes;
}

}  // namespace aips
