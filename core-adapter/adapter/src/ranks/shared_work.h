// Work in parts that are joined in order, of which each rank does some.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "aips/adapter/ranks.h"
#include "ranks/rank_archive.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// Rank r of n does the parts from floor(count r / n) on, to where those of the next begin: what
/// all ranks do, one after the other, is in the order of the parts.
class SharedWork {
  public:
    /// Before the work begins, in `count` parts, the same on all ranks. `ranks`: null for a process
    /// alone, which does all. `filter` is what the work counts invalid samples in; null: nowhere.
    /// Both outlive it.
    SharedWork(Ranks* ranks, std::uint32_t count, InvalidSampleFilter* filter);

    /// Parts of this rank: from first() to below last().
    std::uint32_t first() const { return first_of(rank()); }
    std::uint32_t last() const { return first_of(rank() + 1); }
    /// First part of a rank; of the number of ranks: the number of parts.
    std::uint32_t first_of(std::uint32_t rank) const {
        return static_cast<std::uint32_t>(std::uint64_t{count_} * rank / ranks_count());
    }

    /// Saves what a part left, or puts what it left elsewhere in the same place here. It is called
    /// for several parts at a time, twice to save one, and for the parts of one rank after those of
    /// another.
    using PartState = std::function<void(std::uint32_t part, StateArchive& archive)>;
    /// After the work. What was refused counts on all ranks.
    void exchange(const PartState& state);

  private:
    std::span<const std::byte> pack(const PartState& state);
    void unpack(std::uint32_t other, std::span<const std::byte> message, const PartState& state);
    std::uint32_t rank() const { return ranks_ ? ranks_->rank() : 0; }
    std::uint32_t ranks_count() const { return ranks_ ? ranks_->count() : 1; }

    Ranks* ranks_;
    std::uint32_t count_;
    InvalidSampleFilter* filter_;
    std::vector<std::uint64_t> refused_before_;  // [origin]; empty for a process alone
    std::unique_ptr<std::byte[]> message_;       // of this rank, while it is told
};

/// Does the parts of this rank on all threads by work(part), and takes the others' from their
/// ranks: `state` as SharedWork::exchange takes it.
template <class Work, class State>
void share_out(Ranks* ranks, std::uint32_t count, InvalidSampleFilter* filter, const Work& work,
               const State& state) {
    SharedWork shared(ranks, count, filter);
    tbb::parallel_for(shared.first(), shared.last(), work);
    shared.exchange(state);
}

/// Visible points of a pass by the rank that has their Bsdfs, and so works on them. One that is
/// empty stands for a process alone, which has all.
struct PointOwners {
    Ranks* ranks = nullptr;
    std::vector<std::size_t> begins;  ///< [rank] of its points, and the number of all; with ranks
    bool any_bsdf = false;            ///< whether a point of any rank has one; with ranks

    /// Of `points` in all, those of this rank begin and end here.
    std::size_t first(std::size_t /*points*/) const { return ranks ? begins[ranks->rank()] : 0; }
    std::size_t last(std::size_t points) const {
        return ranks ? begins[ranks->rank() + 1] : points;
    }
    /// Which rank has a point; with ranks.
    std::uint32_t owner_of(std::size_t point) const {
        return std::uint32_t(std::upper_bound(begins.begin(), begins.end(), point) -
                             begins.begin() - 1);
    }
};

/// Work on visible points, each of the rank that has it: one part a rank.
inline SharedWork work_on_points(const PointOwners& owners, InvalidSampleFilter* filter) {
    return {owners.ranks, owners.ranks ? owners.ranks->count() : 1, filter};
}

/// Of values in the points' order, `per_point` each: those of a rank's points.
template <class T>
void plain_of_points(StateArchive& archive, const PointOwners& owners, std::uint32_t rank,
                     std::vector<T>& values, std::size_t per_point = 1) {
    if (values.empty()) return;
    const std::size_t first = owners.begins[rank] * per_point;
    plain(archive,
          std::span<T>(values).subspan(first, owners.begins[rank + 1] * per_point - first));
}

}  // namespace aips
