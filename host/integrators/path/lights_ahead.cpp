// Eye paths that are thrown away, in blocks that are joined in order.
#include "path/lights_ahead.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "path/metropolis_target.h"
#include "path/random_stream.h"

namespace lxs {
namespace {

constexpr std::uint32_t kPathsPerBlock = 256;

struct Block {
    std::vector<aips::LightSample> told;
    PathCounts counts;
};

}  // namespace

std::uint64_t learn_lights_ahead(const RenderContext& context, const PathSettings& settings,
                                 LightSelector& lights) {
    if (!lights.learns() || lights.knows()) return 0;
    const std::uint32_t pixels = context.film.width() * context.film.height();
    const std::uint32_t paths = aips::light_samples_ahead(pixels) / kToldRays;
    std::vector<Block> blocks((paths - 1) / kPathsPerBlock + 1);
    // What is thrown away is not refused either.
    PathSampleFilter of_nothing_seen(context.scene);
    const PathTracer tracer(context.scene, settings, of_nothing_seen);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        PathTarget target(context, tracer, &blocks[b].told);
        Contribution thrown_away;
        const auto first = static_cast<std::uint32_t>(b) * kPathsPerBlock;
        for (std::uint32_t path = first; path < std::min(paths, first + kPathsPerBlock); ++path) {
            RandomStream random(context.settings.seed, 0, path, RandomDomain::LightsAhead);
            target.evaluate(random, thrown_away);
        }
        blocks[b].counts = target.take_counts();
    });
    std::vector<aips::LightSample> told;
    PathCounts counts;
    for (const Block& block : blocks) {
        told.insert(told.end(), block.told.begin(), block.told.end());
        counts += block.counts;
    }
    lights.learn(told, std::uint64_t{paths} * kToldRays, 0);
    return counts.rays;
}

}  // namespace lxs
