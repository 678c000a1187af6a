// Photon paths in blocks; blocks are joined in order.
#include "photons/photon_iteration.h"

#include <tbb/parallel_for.h>

#include "base/parallel_for.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

/// Blocks that one job joins to the others.
constexpr std::size_t kBlocksPerJob = 8;

/// Chosen by a hash: every n-th point of a low-discrepancy sequence is not a fair sample of it.
bool logged(const PhotonInput& input, std::uint64_t serial) {
    if (input.log_one_of == 0) return false;
    const auto key = std::uint32_t(serial) ^ hash_bits(std::uint32_t(serial >> 32) + 1);
    return hash_bits(key ^ 0xA511E9B3u) % input.log_one_of == 0;
}

}  // namespace

PhotonCounts PhotonTracer::trace(const PhotonInput& input, std::uint64_t paths_before_pass,
                                 std::uint32_t first, std::uint32_t count,
                                 InvalidSampleFilter& filter, PhotonStore& store, PathLog* log,
                                 std::vector<VolumePhoton>* collisions) {
    // Nothing is added to `first` and `count` beyond their sum, which may be 2^32 - 1.
    const std::uint32_t block_count = count / kPathsPerBlock + (count % kPathsPerBlock ? 1 : 0);
    if (blocks_.size() < block_count) blocks_.resize(block_count);
    SharedWork work(input.ranks, block_count, &filter);
    tbb::parallel_for(work.first(), work.last(), [&](std::uint32_t b) {
        Arena& arena = arenas_.local();
        Block& block = blocks_[b];
        block.photons.clear();
        block.collisions.clear();
        block.log.clear();
        block.counts.clear();
        const std::uint32_t begin = first + b * kPathsPerBlock;
        const std::uint32_t end = begin + std::min(kPathsPerBlock, first + count - begin);
        SequencePath numbers(input.settings.seed, input.pass, input.sequence_begin);
        for (std::uint32_t i = begin; i < end; ++i) {
            numbers.move_to(paths_before_pass + i, i);
            trace_photon_path(input, numbers, i, filter, arena, block.photons, block.counts,
                              logged(input, paths_before_pass + i) ? &block.log : nullptr,
                              collisions ? &block.collisions : nullptr);
        }
    });
    work.exchange([&](std::uint32_t b, StateArchive& archive) { blocks_[b].state(archive); });
    const std::span blocks = std::span(blocks_).first(block_count);
    PhotonCounts counts = join(blocks, store);
    const auto block_of_paths = [&](std::size_t b) {
        return BlockOfPaths{blocks[b].log, blocks[b].photons};
    };
    if (log) append_logs(blocks.size(), block_of_paths, *log);
    for (const Block& block : blocks) {
        if (collisions) {
            collisions->insert(collisions->end(), block.collisions.begin(), block.collisions.end());
        }
    }
    return counts;
}

std::span<Photon> PhotonStore::grow(std::size_t photons) {
    const std::size_t first = photons_.size(), count = first + photons;
    if (photons_.capacity() < count) {
        UnwrittenVector<Photon> wider;
        wider.reserve(std::max(count, 2 * photons_.capacity()));
        wider.resize(first);
        in_chunks(first, kItemsPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
            std::copy_n(photons_.begin() + std::ptrdiff_t(begin), end - begin,
                        wider.begin() + std::ptrdiff_t(begin));
        });
        photons_.swap(wider);
    }
    photons_.resize(count);
    return std::span(photons_).subspan(first, photons);
}

void PhotonStore::scale_power(std::size_t first, float factor) {
    const std::span<Photon> scaled = std::span(photons_).subspan(first);
    in_chunks(scaled.size(), kItemsPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
        for (Photon& photon : scaled.subspan(begin, end - begin))
            photon.power *= factor;
    });
}

/// Paths in media are traced by each rank itself: their marks of media are its own.
void PhotonTracer::Block::state(StateArchive& archive) {
    state_of(archive, photons, log.paths, log.vertices, counts);
}

/// Counts are integers, whose sums do not depend on the order.
PhotonCounts PhotonTracer::join(std::span<Block> blocks, PhotonStore& store) const {
    std::size_t count = 0;
    for (Block& block : blocks) {
        block.first = count;
        count += block.photons.size();
    }
    const std::span<Photon> joined = store.grow(count);
    std::vector<PhotonCounts> counts((blocks.size() + kBlocksPerJob - 1) / kBlocksPerJob);
    in_chunks(blocks.size(), kBlocksPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
        for (const Block& block : blocks.subspan(begin, end - begin)) {
            std::ranges::copy(block.photons, joined.subspan(block.first).begin());
            counts[begin / kBlocksPerJob] += block.counts;
        }
    });
    PhotonCounts sum;
    for (const PhotonCounts& part : counts)
        sum += part;
    return sum;
}

std::size_t PhotonTracer::memory_bytes() const {
    std::size_t bytes = blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_)
        bytes += block.photons.capacity() * sizeof(Photon) + block.log.memory_bytes() +
                 block.collisions.capacity() * sizeof(VolumePhoton);
    return bytes;
}

}  // namespace aips
