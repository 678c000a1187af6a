// Photon paths in blocks; blocks are joined in order.
#include "photon_iteration.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace aips {
namespace {

constexpr std::uint32_t kPathsPerBlock = 256;

struct Block {
    std::vector<Landing> landings;
    PhotonCounts counts;
};

}  // namespace

PhotonCounts trace_photons(const PhotonInput& input, std::uint64_t paths_before_pass,
                           std::uint32_t first, std::uint32_t count, Refusals& refusals,
                           LandingStore& store) {
    const std::uint32_t block_count = (count + kPathsPerBlock - 1) / kPathsPerBlock;
    std::vector<Block> blocks(block_count);
    tbb::enumerable_thread_specific<Arena> arenas;
    tbb::parallel_for(0u, block_count, [&](std::uint32_t b) {
        Arena& arena = arenas.local();
        const std::uint32_t begin = first + b * kPathsPerBlock;
        const std::uint32_t end = std::min(first + count, begin + kPathsPerBlock);
        for (std::uint32_t i = begin; i < end; ++i) {
            SequencePath numbers(input.settings.seed, input.pass, paths_before_pass + i, i);
            trace_photon_path(input, numbers, i, refusals, arena, blocks[b].landings,
                              blocks[b].counts);
        }
    });
    PhotonCounts counts;
    for (const Block& block : blocks) {
        store.append(block.landings);
        counts += block.counts;
    }
    return counts;
}

}  // namespace aips
