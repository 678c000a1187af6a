// Scores of photons, in parallel.
#include "contribution/iteration_scores.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/vector_growth.h"
#include "contribution/shared_scores.h"

namespace aips {
namespace {

/// Of uneven cost, by how many visible points are around them: some ten microseconds.
constexpr std::size_t kPhotonsPerJob = 8;

}  // namespace

double IterationScores::begin_pass(const EyeImage& image, std::span<const Vec3> positions,
                                   const GatherRadii& radii) {
    const double mean_weight = importance_.weigh(image, weights_);
    score_.build(image, positions, radii, weights_);
    return mean_weight;
}

std::span<const double> IterationScores::of(std::span<const Photon> photons) {
    scores_.resize(photons.size());
    if (!photons.empty() && score_.image().owners.ranks) {
        const auto photon = [&](std::size_t i) -> const Photon& { return photons[i]; };
        score_with_ranks(score_, score_.image().owners, photon, scores_);
        return scores_;
    }
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, photons.size(), kPhotonsPerJob), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            scores_[i] = score_.score(photons[i]);
    });
    return scores_;
}

std::size_t IterationScores::memory_bytes() const {
    return score_.memory_bytes() + weights_.capacity() * sizeof(float) +
           scores_.capacity() * sizeof(double);
}

std::size_t IterationScores::memory_bound_bytes(std::size_t eye_paths, std::size_t photons) {
    return CellSort::memory_bound_bytes(eye_paths) + eye_paths * sizeof(float) +
           kVectorGrowth * photons * sizeof(double);
}

}  // namespace aips
