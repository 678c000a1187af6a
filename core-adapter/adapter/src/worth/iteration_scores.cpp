// Scores of landings, in parallel.
#include "worth/iteration_scores.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/vector_growth.h"
#include "worth/shared_scores.h"

namespace aips {
namespace {

/// Of uneven cost, by how many visible points are around them: some ten microseconds.
constexpr std::size_t kLandingsPerJob = 8;

}  // namespace

double IterationScores::begin_pass(const EyeImage& image, std::span<const Vec3> positions,
                                   const SearchRadii& radii) {
    const double mean_weight = importance_.weigh(image, weights_);
    score_.build(image, positions, radii, weights_);
    return mean_weight;
}

std::span<const double> IterationScores::of(std::span<const Landing> landings) {
    scores_.resize(landings.size());
    if (!landings.empty() && score_.image().owners.ranks) {
        const auto landing = [&](std::size_t i) -> const Landing& { return landings[i]; };
        score_with_ranks(score_, score_.image().owners, landing, scores_);
        return scores_;
    }
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, landings.size(), kLandingsPerJob), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            scores_[i] = score_.score(landings[i]);
    });
    return scores_;
}

std::size_t IterationScores::memory_bytes() const {
    return score_.memory_bytes() + weights_.capacity() * sizeof(float) +
           scores_.capacity() * sizeof(double);
}

std::size_t IterationScores::memory_bound_bytes(std::size_t eye_paths, std::size_t landings) {
    return CellSort::memory_bound_bytes(eye_paths) + eye_paths * sizeof(float) +
           kVectorGrowth * landings * sizeof(double);
}

}  // namespace aips
