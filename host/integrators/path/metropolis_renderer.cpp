// Passes of `path` under Sampler "metropolis".
#include "path/metropolis_renderer.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

namespace lxs {
namespace {

/// Pixels, and with that mutations of a pass, that make a chain of its own worth its start.
constexpr std::size_t kPixelsPerChain = 32;
constexpr std::size_t kFewestChains = 16, kMostChains = 256;
/// Plain samples before the chains start: one a pixel within these bounds.
constexpr std::size_t kFewestPlain = std::size_t{1} << 14, kMostPlain = std::size_t{1} << 18;

double share(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

MetropolisRenderer::MetropolisRenderer(const RenderContext& context, const PathTracer& tracer,
                                       const MetropolisSettings& settings)
    : context_(context), tracer_(tracer), settings_(settings) {
    const std::size_t pixels = std::size_t{context.film.width()} * context.film.height();
    const std::size_t chains = std::clamp(pixels / kPixelsPerChain, kFewestChains, kMostChains);
    positions_.resize(pixels + chains);
    radiance_.resize(positions_.size() * context.film.light_groups());
    for (std::size_t i = 0; i < chains; ++i) {
        const std::size_t first = pixels * i / chains, end = pixels * (i + 1) / chains;
        lanes_.push_back(
            {.chain = MetropolisChain(settings, context.film.width(), context.film.height(),
                                      context.settings.seed, static_cast<std::uint32_t>(i)),
             .mutations = end - first,
             .first_splat = first + i});
    }
}

std::string MetropolisRenderer::text() const {
    return fmt::format(
        "Metropolis sampling with {} chains, largemutationprob {}, maxconsecrejects {}",
        lanes_.size(), settings_.large_probability, settings_.max_consecutive_rejects);
}

PathCounts MetropolisRenderer::render_pass() {
    PathCounts paths;
    if (guess_ == 0) paths += seed_chains();
    if (guess_ == 0) return paths;
    const MeanBrightness b{guess_, mean_brightness()};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lanes_.size()), [&](const auto& range) {
        PathTarget target(context_, tracer_);
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            run_lane(lanes_[i], b, target);
    });
    for (const Lane& lane : lanes_) {
        total_ += lane.counts;
        paths += lane.paths;
    }
    splat();
    return paths;
}

void MetropolisRenderer::run_lane(Lane& lane, const MeanBrightness& b, PathTarget& target) {
    const std::size_t groups = context_.film.light_groups();
    const std::size_t room = lane.mutations + 1;
    SplatList splats{std::span(positions_).subspan(lane.first_splat, room),
                     std::span(radiance_).subspan(lane.first_splat * groups, room * groups)};
    lane.counts = lane.chain.run(lane.mutations, b, target, splats);
    lane.splats = splats.used;
    lane.paths = target.take_counts();
}

/// Closes the gaps between the lanes' splats and hands them to the film.
void MetropolisRenderer::splat() {
    const std::size_t groups = context_.film.light_groups();
    std::size_t used = 0;
    std::uint64_t mutations = 0;
    for (const Lane& lane : lanes_) {
        std::copy_n(&positions_[lane.first_splat], lane.splats, &positions_[used]);
        std::copy_n(&radiance_[lane.first_splat * groups], lane.splats * groups,
                    &radiance_[used * groups]);
        used += lane.splats;
        mutations += lane.mutations;
    }
    context_.film.add_splats({.positions = std::span(positions_).first(used),
                              .radiance = std::span(radiance_).first(used * groups),
                              .groups = context_.film.light_groups(),
                              .samples = static_cast<double>(mutations)});
}

RandomStream MetropolisRenderer::plain_sample(std::uint64_t index) const {
    return {context_.settings.seed, index, 0, RandomDomain::MetropolisSeeds};
}

PathCounts MetropolisRenderer::seed_chains() {
    PathCounts paths;
    const std::vector<double> brightness = plain_brightness(paths);
    double total = 0;
    for (const double i : brightness)
        total += i;
    plain_samples_ += brightness.size();
    if (total > 0) {
        plain_brightness_ = total;
        guess_ = mean_brightness();
        start_chains(brightness, total);
        context_.log.info(
            fmt::format("path: mean brightness {} from {} plain samples", guess_, plain_samples_));
    } else if (!warned_) {
        warned_ = true;
        context_.log.warning(
            fmt::format("path: no light in {} plain samples: the image stays black until a later "
                        "pass finds some",
                        plain_samples_));
    }
    return paths;
}

/// I of the next plain samples.
std::vector<double> MetropolisRenderer::plain_brightness(PathCounts& counts) const {
    const std::size_t pixels = std::size_t{context_.film.width()} * context_.film.height();
    std::vector<double> brightness(std::clamp(pixels, kFewestPlain, kMostPlain));
    std::mutex counting;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, brightness.size(), 256),
                      [&](const auto& range) {
                          PathTarget target(context_, tracer_);
                          Contribution contribution;
                          for (std::size_t i = range.begin(); i != range.end(); ++i) {
                              RandomStream sample = plain_sample(plain_samples_ + i);
                              target.evaluate(sample, contribution);
                              brightness[i] = contribution.brightness;
                          }
                          const std::lock_guard lock(counting);
                          counts += target.take_counts();
                      });
    return brightness;
}

/// Starts every chain at one of the last plain samples, drawn in proportion to I by systematic
/// resampling.
void MetropolisRenderer::start_chains(const std::vector<double>& brightness, double total) {
    const std::uint64_t first = plain_samples_ - brightness.size();
    const double offset =
        RandomStream(context_.settings.seed, first, 1, RandomDomain::MetropolisSeeds).next();
    PathTarget target(context_, tracer_);
    std::size_t i = 0, last_lit = 0;
    double sum = 0;  // of brightness before sample i
    for (std::size_t k = 0; k < lanes_.size(); ++k) {
        const double at =
            (static_cast<double>(k) + offset) / static_cast<double>(lanes_.size()) * total;
        while (i < brightness.size() && sum + brightness[i] <= at) {
            if (brightness[i] > 0) last_lit = i;
            sum += brightness[i++];
        }
        lanes_[k].chain.start(plain_sample(first + (i < brightness.size() ? i : last_lit)), target);
    }
}

/// Estimate of b from all plain samples and large steps so far.
double MetropolisRenderer::mean_brightness() const {
    const std::uint64_t samples = plain_samples_ + total_.large;
    return samples > 0
               ? (plain_brightness_ + total_.large_brightness) / static_cast<double>(samples)
               : 0;
}

Statistics MetropolisRenderer::statistics() const {
    return {
        {"metropolis chains", std::uint64_t{lanes_.size()}},
        {"metropolis mutations", total_.mutations},
        {"metropolis acceptance rate", share(total_.accepted, total_.mutations)},
        {"metropolis acceptance rate of large steps", share(total_.accepted_large, total_.large)},
        {"metropolis acceptance rate of small steps",
         share(total_.accepted - total_.accepted_large, total_.mutations - total_.large)},
        {"metropolis forced acceptances", total_.forced},
        {"metropolis plain samples for b", plain_samples_ + total_.large},
        {"metropolis b", mean_brightness()}};
}

}  // namespace lxs
