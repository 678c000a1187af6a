// Ranks that are threads of one process: what they share is tested without MPI.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "aips/adapter/ranks.h"

namespace mock {

/// A job of threads that tell each other messages.
class ThreadRanks {
  public:
    explicit ThreadRanks(std::uint32_t count) : told_(count) {}

    /// Calls `work` with each of the ranks, on a thread of its own. Throws what a rank threw; the
    /// others are then told that it is gone.
    void run(const std::function<void(aips::Ranks& ranks)>& work);
    /// Bytes that all ranks together told so far.
    std::size_t bytes() const { return bytes_; }

  private:
    class Rank;

    aips::RankMessages exchange(std::uint32_t rank, std::span<const std::byte> own);
    void leave();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::vector<std::byte>> told_;  // [rank] in this exchange
    aips::RankMessages messages_;               // of the last
    std::uint64_t exchanges_ = 0;
    std::uint32_t arrived_ = 0;
    std::size_t bytes_ = 0;
    bool gone_ = false;
};

}  // namespace mock
