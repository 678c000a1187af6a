// Sums over what came after a path's vertices.
#include "contribution/path_contribution.h"

#include <algorithm>

#include "base/parallel_for.h"
#include "base/vector_growth.h"

namespace aips {
namespace {

constexpr std::size_t kPathsPerJob = 256;

}  // namespace

void PathContributions::measure(const PathLog& log, std::span<const double> scores) {
    scores_ = scores;
    paths_.resize(log.paths.size());
    vertices_.resize(log.vertices.size());
    in_chunks(paths_.size(), kPathsPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
        for (std::size_t path = begin; path < end; ++path)
            measure_path(log, path);
    });
}

// From the path's end to its start, summing what came after.
void PathContributions::measure_path(const PathLog& log, std::size_t number) {
    const PathRecord& path = log.paths[number];
    const std::span landed_scores = scores(path);
    double score = 0;
    double landed = 0, rays = 0;
    std::uint32_t last_rays = path.rays;
    std::uint32_t l = path.photons;
    const auto take_photons_after = [&](std::uint32_t depth) {
        for (; l > 0 && log.photons[path.first_photon + l - 1].depth > depth; --l) {
            score += landed_scores[l - 1];
            landed += 1;
        }
    };
    for (std::uint32_t v = path.vertices; v-- > 0;) {
        const PathVertex& vertex = log.vertices[path.first_vertex + v];
        take_photons_after(vertex.depth);
        rays += last_rays - vertex.rays;
        last_rays = vertex.rays;
        vertices_[path.first_vertex + v] = {score, rays + kPhotonCost * landed};
        const double copies = std::max(1.0, double(vertex.survival.photons));
        score *= copies;
        rays *= copies;
        landed *= copies;
    }
    take_photons_after(0);
    rays += last_rays;
    paths_[number] = {score, kPhotonCost + rays + kPhotonCost * landed};
}

std::size_t PathContributions::memory_bytes() const {
    return (paths_.capacity() + vertices_.capacity()) * sizeof(PathContribution);
}

std::size_t PathContributions::memory_bound_bytes(std::size_t paths, std::size_t depth) {
    return kVectorGrowth * paths * (1 + depth) * sizeof(PathContribution);
}

}  // namespace aips
