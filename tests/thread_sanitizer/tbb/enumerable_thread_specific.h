// Stands in for oneTBB's header of this name in builds with the thread sanitizer, as parallel_for.h
// does. Of the interface it has what the project uses: each thread's own value. To look through the
// values of all would need those of threads that have ended.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>

namespace tbb {

/// As oneTBB's. A thread's value ends with the thread, or with the container on the thread that
/// ends it.
template <class T>
class enumerable_thread_specific {
  public:
    enumerable_thread_specific() = default;
    enumerable_thread_specific(const enumerable_thread_specific&) = delete;
    enumerable_thread_specific& operator=(const enumerable_thread_specific&) = delete;
    ~enumerable_thread_specific() { values().erase(number_); }

    T& local() { return values()[number_]; }

  private:
    /// By the container's number: another one may later have its address.
    static std::map<std::uint64_t, T>& values() {
        thread_local std::map<std::uint64_t, T> of_this_thread;
        return of_this_thread;
    }
    static std::uint64_t next_number() {
        static std::atomic<std::uint64_t> next{0};
        return next.fetch_add(1, std::memory_order_relaxed);
    }

    const std::uint64_t number_ = next_number();
};

}  // namespace tbb
