// Passes of `path` under Sampler "metropolis".
#include "path/metropolis_renderer.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <mutex>

namespace lxs {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

MetropolisRenderer::MetropolisRenderer(const RenderContext& context, const PathTracer& tracer,
                                       const MetropolisSettings& settings)
    : context_(context),
      tracer_(tracer),
      settings_(settings),
      population_(settings, context.film.width(), context.film.height(),
                  context.film.light_groups(), context.settings.seed) {}

std::string MetropolisRenderer::text() const {
    return fmt::format(
        "Metropolis sampling with {} chains, largemutationprob {}, maxconsecrejects {}",
        population_.chains(), settings_.large_probability, settings_.max_consecutive_rejects);
}

PathCounts MetropolisRenderer::render_pass() {
    PathCounts counts;
    if (!population_.has_guess() && !start(counts)) return counts;
    std::mutex counting;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, population_.chains()),
                      [&](const auto& range) {
                          PathTarget target(context_, tracer_);
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                              population_.run(i, target);
                          const std::lock_guard lock(counting);
                          counts += target.take_counts();
                      });
    const MetropolisPopulation::Splats splats = population_.finish_pass();
    context_.film.add_splats({.positions = splats.positions,
                              .radiance = splats.radiance,
                              .groups = context_.film.light_groups(),
                              .samples = static_cast<double>(splats.mutations)});
    return counts;
}

/// False, and a warning the first time, if there is no light to start from.
bool MetropolisRenderer::start(PathCounts& counts) {
    if (population_.guess_from(plain_brightness(counts))) {
        context_.log.debug(fmt::format("path: mean brightness {} from {} plain samples",
                                       population_.mean_brightness(), population_.plain_samples()));
        population_.start_from(plain_brightness(counts));
        return true;
    }
    if (!warned_) {
        warned_ = true;
        context_.log.warning(
            fmt::format("path: no light in {} plain samples: the image stays black until a later "
                        "pass finds some",
                        population_.plain_samples()));
    }
    return false;
}

/// I of the next plain samples.
std::vector<double> MetropolisRenderer::plain_brightness(PathCounts& counts) const {
    std::vector<double> brightness(population_.starting_samples());
    std::mutex counting;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, brightness.size(), 256), [&](const auto& range) {
            PathTarget target(context_, tracer_);
            Contribution contribution;
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
                RandomStream sample = population_.plain_sample(population_.plain_samples() + i);
                target.evaluate(sample, contribution);
                brightness[i] = contribution.brightness;
            }
            const std::lock_guard lock(counting);
            counts += target.take_counts();
        });
    return brightness;
}

void MetropolisRenderer::state(StateArchive& archive) {
    archive.value(warned_);
    population_.state(archive);
}

Statistics MetropolisRenderer::statistics() const {
    const ChainCounts& total = population_.counts();
    return {{"metropolis chains", std::uint64_t{population_.chains()}},
            {"metropolis chain starts", population_.starts()},
            {"metropolis mutations", total.mutations},
            {"metropolis acceptance rate", share(total.accepted, total.mutations)},
            {"metropolis acceptance rate of large steps", share(total.accepted_large, total.large)},
            {"metropolis acceptance rate of small steps",
             share(total.accepted - total.accepted_large, total.mutations - total.large)},
            {"metropolis forced acceptances", total.forced},
            {"metropolis plain samples for b", population_.plain_samples()},
            {"metropolis b", population_.mean_brightness()}};
}

}  // namespace lxs
