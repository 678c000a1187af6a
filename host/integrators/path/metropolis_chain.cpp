// One Markov chain of primary-sample-space Metropolis sampling.
#include "path/metropolis_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lxs {
namespace {

/// LuxRender's share of width + height that a small mutation may move a sample on the film.
constexpr double kFilmShare = 1.0 / 32;
/// Largest over smallest of those moves: LuxRender's number.
constexpr double kFilmSpread = 32;

MutationRange film_range(const MetropolisSettings& settings, std::uint32_t width,
                         std::uint32_t height, std::uint32_t size) {
    const double pixels = settings.film_range > 0
                              ? settings.film_range
                              : kFilmShare * (static_cast<double>(width) + height);
    return {pixels / kFilmSpread / size, pixels / size};
}

}  // namespace

void SplatList::add(const Contribution& contribution, double weight) {
    const std::size_t groups = contribution.radiance.size();
    positions[used] = contribution.position;
    for (std::size_t g = 0; g < groups; ++g)
        radiance[used * groups + g] = contribution.radiance[g] * static_cast<float>(weight);
    ++used;
}

ChainCounts& ChainCounts::operator+=(const ChainCounts& other) {
    mutations += other.mutations;
    accepted += other.accepted;
    large += other.large;
    accepted_large += other.accepted_large;
    forced += other.forced;
    large_brightness += other.large_brightness;
    return *this;
}

void ChainCounts::state(StateArchive& archive) {
    for (std::uint64_t* count : {&mutations, &accepted, &large, &accepted_large, &forced})
        archive.value(*count);
    archive.value(large_brightness);
}

MetropolisChain::MetropolisChain(const MetropolisSettings& settings, std::uint32_t width,
                                 std::uint32_t height, std::uint64_t seed, std::uint32_t index)
    : settings_(settings),
      seed_(seed),
      index_(index),
      coordinates_(film_range(settings, width, height, width),
                   film_range(settings, width, height, height)) {}

void MetropolisChain::start(const RandomStream& sample, double mean, MetropolisTarget& target) {
    mean_ = mean;
    rejects_in_a_row_ = 0;
    coordinates_.propose(sample, true);
    target.evaluate(coordinates_, present_.contribution);
    coordinates_.accept();
}

void MetropolisChain::start_dark() {
    mean_ = 0;
}

RandomStream MetropolisChain::plain_sample(std::uint64_t mutation) const {
    RandomStream random(seed_, mutation, index_, RandomDomain::MetropolisChain);
    random.next_2d();  // whether the step is large, whether it is accepted
    return random;
}

void MetropolisChain::state(StateArchive& archive, std::uint32_t groups) {
    coordinates_.state(archive);
    Contribution& present = present_.contribution;
    archive.value(present.position.x);
    archive.value(present.position.y);
    // Empty before the first start.
    present.radiance.resize(archive.count(present.radiance.size(), sizeof(float) * 3));
    for (Rgb& c : present.radiance) {
        for (float* component : {&c.x, &c.y, &c.z})
            archive.value(*component);
    }
    archive.value(present.brightness);
    archive.value(mean_);
    archive.value(mutations_);
    archive.value(rejects_in_a_row_);
    const bool sound = (present.radiance.size() == groups ||
                        (present.radiance.empty() && present.brightness == 0)) &&
                       present.brightness >= 0 && std::isfinite(present.brightness) && mean_ >= 0 &&
                       std::isfinite(mean_);
    if (!sound) throw StateError("a chain is in no possible state");
}

ChainCounts MetropolisChain::run(std::uint64_t mutations, double guess, MetropolisTarget& target,
                                 SplatList& splats, std::vector<LitSample>& lit) {
    ChainCounts counts;
    for (std::uint64_t i = 0; i < mutations; ++i)
        step(guess, target, splats, counts, lit);
    give(present_, guess, splats);
    return counts;
}

void MetropolisChain::step(double guess, MetropolisTarget& target, SplatList& splats,
                           ChainCounts& counts, std::vector<LitSample>& lit) {
    RandomStream random(seed_, mutations_, index_, RandomDomain::MetropolisChain);
    const bool large = random.next() < settings_.large_probability;
    const float threshold = random.next();
    coordinates_.propose(random, large);
    target.evaluate(coordinates_, proposed_.contribution);
    const double from = present_.contribution.brightness, to = proposed_.contribution.brightness;
    ++counts.mutations;
    if (large) {
        ++counts.large;
        counts.large_brightness += to;
        if (to > 0) lit.push_back({mutations_, to});
    }
    ++mutations_;

    const double acceptance = to >= from ? 1 : to / from;
    const double visit = mean_ / guess;
    proposed_.weight = visit * acceptance + (large ? 1 : 0);
    present_.weight += visit * (1 - acceptance);
    const bool stuck = settings_.max_consecutive_rejects > 0 && to > 0 &&
                       rejects_in_a_row_ >= settings_.max_consecutive_rejects;
    if (threshold < acceptance || stuck) {
        if (!(threshold < acceptance)) ++counts.forced;
        give(present_, guess, splats);
        std::swap(present_, proposed_);
        coordinates_.accept();
        rejects_in_a_row_ = 0;
        ++counts.accepted;
        if (large) ++counts.accepted_large;
    } else {
        give(proposed_, guess, splats);
        ++rejects_in_a_row_;
    }
}

/// Hands the weight of a state over to the image.
void MetropolisChain::give(State& state, double guess, SplatList& splats) const {
    const double weight = std::exchange(state.weight, 0.0);
    const double brightness = state.contribution.brightness;
    if (weight == 0 || brightness == 0) return;
    splats.add(state.contribution, weight / (brightness / guess + settings_.large_probability));
}

}  // namespace lxs
