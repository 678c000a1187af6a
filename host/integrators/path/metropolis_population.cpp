// Many Markov chains side by side over one function, renewed one after the other.
#include "path/metropolis_population.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

/// Pixels, and with that mutations of a pass, that make a chain of its own worth its start.
constexpr std::size_t kPixelsPerChain = 32;
constexpr std::size_t kFewestChains = 16, kMostChains = 256;
/// Plain samples that guess b, and that start the chains: one for two pixels within these bounds.
constexpr std::size_t kFewestStarting = std::size_t{1} << 13, kMostStarting = std::size_t{1} << 17;
/// Large steps that are enough to renew chains from.
constexpr std::uint64_t kEnoughToRenew = 1024;
/// One chain in so many is renewed at a time. The fewer, the sooner an image has what large steps
/// have found: after 18 passes of glass-ball its variance is the same from 1 to 4, and with 8 and
/// 16 it is 1.4 and 2.7 times that.
constexpr std::size_t kGenerations = 4;

}  // namespace

std::vector<std::size_t> resample(std::span<const double> brightness, std::size_t count,
                                  double offset) {
    double total = 0;
    for (const double i : brightness)
        total += i;
    std::vector<std::size_t> drawn(count);
    // The draws in the order of the samples; the first of them is the one that wraps around.
    const double scaled = offset * static_cast<double>(count);
    const auto turn = static_cast<std::size_t>(scaled);
    std::size_t i = 0, last_lit = 0;
    double sum = 0;  // of brightness before sample i
    for (std::size_t k = 0; k < count; ++k) {
        const double at = (static_cast<double>(k) + scaled - static_cast<double>(turn)) /
                          static_cast<double>(count) * total;
        while (i < brightness.size() && sum + brightness[i] <= at) {
            if (brightness[i] > 0) last_lit = i;
            sum += brightness[i++];
        }
        drawn[(k + turn) % count] = i < brightness.size() ? i : last_lit;
    }
    return drawn;
}

MetropolisPopulation::MetropolisPopulation(const MetropolisSettings& settings, std::uint32_t width,
                                           std::uint32_t height, std::uint32_t groups,
                                           std::uint64_t seed)
    : seed_(seed), groups_(groups) {
    const std::size_t pixels = std::size_t{width} * height;
    starting_samples_ = std::clamp(pixels / 2, kFewestStarting, kMostStarting);
    const std::size_t chains = std::clamp(pixels / kPixelsPerChain, kFewestChains, kMostChains);
    positions_.resize(pixels + chains);
    radiance_.resize(positions_.size() * groups);
    for (std::size_t i = 0; i < chains; ++i) {
        const std::size_t first = pixels * i / chains, end = pixels * (i + 1) / chains;
        lanes_.push_back(
            {.chain = MetropolisChain(settings, width, height, seed, static_cast<std::uint32_t>(i)),
             .mutations = end - first,
             .first_splat = first + i});
    }
}

RandomStream MetropolisPopulation::plain_sample(std::uint64_t index) const {
    return {seed_, index, 0, RandomDomain::MetropolisSeeds};
}

bool MetropolisPopulation::guess_from(std::span<const double> brightness) {
    for (const double i : brightness)
        plain_brightness_ += i;
    plain_samples_ += brightness.size();
    guess_ = mean_brightness();
    return has_guess();
}

void MetropolisPopulation::start_from(std::span<const double> brightness) {
    const std::uint64_t first = plain_samples_;
    for (const double i : brightness)
        plain_brightness_ += i;
    plain_samples_ += brightness.size();
    assign(brightness, brightness.size(), 0, 1,
           [&](std::size_t i) { return plain_sample(first + i); });
}

void MetropolisPopulation::assign(std::span<const double> brightness, std::uint64_t samples,
                                  std::size_t first, std::size_t stride,
                                  const std::function<RandomStream(std::size_t)>& sample) {
    const double offset =
        RandomStream(seed_, assignments_++, 1, RandomDomain::MetropolisSeeds).next();
    double total = 0;
    for (const double i : brightness)
        total += i;
    std::vector<std::size_t> drawn;
    if (total > 0)
        drawn = resample(brightness, (lanes_.size() - first + stride - 1) / stride, offset);
    for (std::size_t k = 0; first + k * stride < lanes_.size(); ++k) {
        ChainStart& start = lanes_[first + k * stride].start.emplace();
        start.mean = total / static_cast<double>(samples);
        if (total > 0) start.sample = sample(drawn[k]);
        ++starts_;
    }
}

void MetropolisPopulation::run(std::size_t chain, MetropolisTarget& target) {
    Lane& lane = lanes_[chain];
    if (lane.start) {
        if (lane.start->sample)
            lane.chain.start(*lane.start->sample, lane.start->mean, target);
        else
            lane.chain.start_dark();
        lane.start.reset();
    }
    const std::size_t room = lane.mutations + 1;
    SplatList splats{std::span(positions_).subspan(lane.first_splat, room),
                     std::span(radiance_).subspan(lane.first_splat * groups_, room * groups_)};
    lane.counts = lane.chain.run(lane.mutations, guess_, target, splats, lane.lit);
    lane.splats = splats.used;
}

MetropolisPopulation::Splats MetropolisPopulation::finish_pass() {
    std::size_t used = 0;
    std::uint64_t mutations = 0;
    for (const Lane& lane : lanes_) {
        total_ += lane.counts;
        large_since_renewal_ += lane.counts.large;
        std::copy_n(&positions_[lane.first_splat], lane.splats, &positions_[used]);
        std::copy_n(&radiance_[lane.first_splat * groups_], lane.splats * groups_,
                    &radiance_[used * groups_]);
        used += lane.splats;
        mutations += lane.mutations;
    }
    if (large_since_renewal_ >= kEnoughToRenew) renew_some();
    return {std::span(positions_).first(used), std::span(radiance_).first(used * groups_),
            mutations};
}

/// Renews the chains whose turn it is from all large steps since the last time.
void MetropolisPopulation::renew_some() {
    std::vector<double> brightness;
    std::vector<RandomStream> samples;
    for (Lane& lane : lanes_) {
        for (const LitSample& lit : lane.lit) {
            brightness.push_back(lit.brightness);
            samples.push_back(lane.chain.plain_sample(lit.mutation));
        }
        lane.lit.clear();
    }
    assign(brightness, large_since_renewal_, renewals_ % kGenerations, kGenerations,
           [&](std::size_t i) { return samples[i]; });
    large_since_renewal_ = 0;
    ++renewals_;
}

void MetropolisPopulation::state(StateArchive& archive) {
    for (double* figure : {&guess_, &plain_brightness_})
        archive.value(*figure);
    for (std::uint64_t* count :
         {&plain_samples_, &large_since_renewal_, &assignments_, &renewals_, &starts_})
        archive.value(*count);
    total_.state(archive);
    if (archive.count(lanes_.size(), 1) != lanes_.size())
        throw StateError("there are not as many chains as the film has");
    for (Lane& lane : lanes_)
        lane_state(archive, lane);
    if (!(guess_ >= 0) || !std::isfinite(guess_))
        throw StateError("the mean brightness is no possible one");
}

/// What a lane did in its last pass is with the film already.
void MetropolisPopulation::lane_state(StateArchive& archive, Lane& lane) {
    lane.chain.state(archive, groups_);
    lane.lit.resize(archive.count(lane.lit.size(), sizeof(LitSample::mutation) + sizeof(double)));
    for (LitSample& lit : lane.lit) {
        archive.value(lit.mutation);
        archive.value(lit.brightness);
        if (!(lit.brightness > 0) || !std::isfinite(lit.brightness))
            throw StateError("a lit sample is not lit");
    }
    bool has_start = lane.start.has_value();
    archive.value(has_start);
    if (!has_start) return lane.start.reset();
    if (!lane.start) lane.start.emplace();
    archive.value(lane.start->mean);
    bool has_sample = lane.start->sample.has_value();
    archive.value(has_sample);
    if (!has_sample) return lane.start->sample.reset();
    if (!lane.start->sample) lane.start->sample.emplace(plain_sample(0));
    lane.start->sample->state(archive);
}

double MetropolisPopulation::mean_brightness() const {
    const std::uint64_t samples = plain_samples();
    return samples > 0
               ? (plain_brightness_ + total_.large_brightness) / static_cast<double>(samples)
               : 0;
}

}  // namespace lxs
