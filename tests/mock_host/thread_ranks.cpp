// Ranks that are threads.
#include "thread_ranks.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <thread>

namespace mock {

class ThreadRanks::Rank final : public aips::Ranks {
  public:
    Rank(ThreadRanks& job, std::uint32_t rank) : job_(job), rank_(rank) {}
    std::uint32_t rank() const override { return rank_; }
    std::uint32_t count() const override { return std::uint32_t(job_.told_.size()); }
    aips::RankMessages exchange(std::span<const std::byte> own) override {
        return job_.exchange(rank_, own);
    }

  private:
    ThreadRanks& job_;
    std::uint32_t rank_;
};

aips::RankMessages ThreadRanks::exchange(std::uint32_t rank, std::span<const std::byte> own) {
    std::unique_lock lock(mutex_);
    told_[rank].assign(own.begin(), own.end());
    const std::uint64_t present = exchanges_;
    if (++arrived_ == told_.size()) {
        std::vector<std::size_t> begins{0};
        for (const std::vector<std::byte>& message : told_)
            begins.push_back(begins.back() + message.size());
        const auto bytes = std::make_shared_for_overwrite<std::byte[]>(begins.back());
        for (std::size_t r = 0; r < told_.size(); ++r)
            std::ranges::copy(told_[r], bytes.get() + begins[r]);
        bytes_ += begins.back();
        messages_ = {bytes, std::move(begins)};
        arrived_ = 0;
        ++exchanges_;
        changed_.notify_all();
    }
    changed_.wait(lock, [&] { return exchanges_ != present || gone_; });
    if (exchanges_ == present) throw std::runtime_error("a rank is gone");
    // Nobody overwrites them before all have arrived again.
    return messages_;
}

void ThreadRanks::leave() {
    const std::lock_guard lock(mutex_);
    gone_ = true;
    changed_.notify_all();
}

void ThreadRanks::run(const std::function<void(aips::Ranks&)>& work) {
    std::exception_ptr first;
    {
        std::vector<std::jthread> threads;
        for (std::uint32_t r = 0; r < told_.size(); ++r) {
            threads.emplace_back([&, r] {
                try {
                    Rank rank(*this, r);
                    work(rank);
                } catch (...) {
                    leave();
                    const std::lock_guard lock(mutex_);
                    if (!first) first = std::current_exception();
                }
            });
        }
    }
    if (first) std::rethrow_exception(first);
}

}  // namespace mock
