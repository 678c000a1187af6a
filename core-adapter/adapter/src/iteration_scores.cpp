// Scores of all landings of an iteration.
#include "iteration_scores.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "vector_growth.h"

namespace aips {

void IterationScores::begin_pass(const EyeImage& image, std::span<const Vec3> positions,
                                 const SearchRadii& radii) {
    importance_.weigh(image, weights_);
    score_.build(image, positions, radii, weights_);
}

std::span<const double> IterationScores::of(std::span<const Landing> landings) {
    scores_.resize(landings.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, landings.size(), 128), [&](const Range& range) {
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
