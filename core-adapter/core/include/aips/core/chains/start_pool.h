// Visible paths with their weights, from which chains start in proportion to these.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace aips {

/// A path that was drawn and found visible.
struct WeightedPath {
    std::uint64_t number = 0;  ///< of the path, by which it can be traced again
    double weight = 0;         ///< density that chains walk by over the one it was drawn from, > 0
};

/// What visible paths weighed.
struct WeightSums {
    double sum = 0, squares = 0;

    void add(double weight) {
        sum += weight;
        squares += weight * weight;
    }
    /// How many paths of equal weight would tell as much.
    double effective() const { return squares > 0 ? sum * sum / squares : 0; }
    WeightSums& operator+=(const WeightSums& o) {
        sum += o.sum;
        squares += o.squares;
        return *this;
    }
    /// Saves or restores the sums.
    void state(StateArchive& archive) {
        archive.amount(sum);
        archive.amount(squares);
    }
};

/// Keeps up to `capacity` paths. Where more come, a systematic resampling thins them: what is kept
/// stands for the others, and weighted means keep their expectation.
class StartPool {
  public:
    /// At least 2.
    explicit StartPool(std::size_t capacity) : capacity_(capacity) {}

    void clear() { paths_.clear(); }
    bool empty() const { return paths_.empty(); }
    std::size_t size() const { return paths_.size(); }
    /// Sum of all weights that were added.
    double weight() const { return paths_.empty() ? 0 : paths_.back().until; }

    /// `u` in [0, 1), independent of all else, decides which paths stay where there are too many.
    void add(std::span<const WeightedPath> paths, double u) {
        for (const WeightedPath& path : paths)
            paths_.push_back({path.number, weight() + path.weight});
        if (paths_.size() > capacity_) thin(u);
    }

    /// The path at `position` in [0, 1) of all weight; must not be empty. A uniform position draws
    /// a path in proportion to its weight.
    std::uint64_t at(double position) const {
        const auto it = std::ranges::upper_bound(paths_, position * weight(), {}, &Path::until);
        return it == paths_.end() ? paths_.back().number : it->number;
    }

    std::size_t memory_bytes() const {
        return (paths_.capacity() + thinned_.capacity()) * sizeof(Path);
    }
    /// With up to `added` paths added at once, and vectors that at most double when they grow.
    static std::size_t memory_bound_bytes(std::size_t capacity, std::size_t added) {
        return (2 * (capacity + added) + capacity / 2) * sizeof(Path);
    }

  private:
    struct Path {
        std::uint64_t number = 0;
        double until = 0;  // weight of all up to and including it
    };

    void thin(double u) {
        const std::size_t kept = capacity_ / 2;
        const double step = weight() / double(kept);
        thinned_.reserve(kept);
        std::size_t from = 0;
        for (std::size_t k = 0; k < kept; ++k) {
            while (from + 1 < paths_.size() && paths_[from].until <= (double(k) + u) * step)
                ++from;
            thinned_.push_back({paths_[from].number, double(k + 1) * step});
        }
        paths_ = thinned_;
        thinned_.clear();
    }

    std::size_t capacity_;
    std::vector<Path> paths_, thinned_;
};

}  // namespace aips
