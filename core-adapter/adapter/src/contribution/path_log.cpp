// Joining of logs.
#include "contribution/path_log.h"

#include "base/parallel_for.h"

namespace aips {
namespace {

/// Blocks that one job joins to the others.
constexpr std::size_t kBlocksPerJob = 8;

template <class T>
std::span<T> from(std::vector<T>& values, std::size_t first) {
    return std::span(values).subspan(first);
}

/// Copies a block's log to where its parts begin.
void copy(const BlockOfPaths& block, PathLogSize first, PathLog& log) {
    std::ranges::copy(block.log.vertices, from(log.vertices, first.vertices).begin());
    for (PathRecord record : block.log.paths) {
        std::ranges::copy(block.photons.subspan(record.first_photon, record.photons),
                          from(log.photons, first.photons).begin());
        record.first_vertex += static_cast<std::uint32_t>(first.vertices);
        record.first_photon = static_cast<std::uint32_t>(first.photons);
        first.photons += record.photons;
        log.paths[first.paths++] = record;
    }
}

}  // namespace

PathLogSize PathLogSize::of(const PathLog& log) {
    PathLogSize size{log.paths.size(), log.vertices.size(), 0};
    for (const PathRecord& record : log.paths)
        size.photons += record.photons;
    return size;
}

PathLogSize& PathLogSize::operator+=(const PathLogSize& other) {
    paths += other.paths;
    vertices += other.vertices;
    photons += other.photons;
    return *this;
}

void append_logs(std::size_t count, const std::function<BlockOfPaths(std::size_t)>& block,
                 PathLog& log) {
    PathLogSize end{log.paths.size(), log.vertices.size(), log.photons.size()};
    std::vector<PathLogSize> first(count);
    for (std::size_t b = 0; b < count; ++b) {
        first[b] = end;
        end += PathLogSize::of(block(b).log);
    }
    log.paths.resize(end.paths);
    log.vertices.resize(end.vertices);
    log.photons.resize(end.photons);
    in_chunks(count, kBlocksPerJob, tbb_for, [&](std::size_t begin, std::size_t last) {
        for (std::size_t b = begin; b < last; ++b)
            copy(block(b), first[b], log);
    });
}

}  // namespace aips
