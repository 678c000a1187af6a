// Stands in for oneTBB's header of this name in builds with the thread sanitizer. The packaged
// oneTBB is not instrumented: the sanitizer does not see how its threads wait for each other, and
// reports all they share. Here the threads are the standard library's, whose start and end it sees;
// nothing else orders one piece of work before another, so that a race in a body is always one in
// the sanitizer's eyes too.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {
namespace sanitized {

/// As many threads as a program asked oneTBB for; where none did, 8 on small machines, too.
inline std::size_t allowed_threads() {
    const std::size_t asked = global_control::active_value(global_control::max_allowed_parallelism);
    const auto processors = static_cast<std::size_t>(info::default_concurrency());
    return asked == processors ? std::max<std::size_t>(asked, 8) : asked;
}

/// Calls piece(i) once for each i below `pieces`, from allowed_threads() threads; throws the first
/// exception of a piece when all threads have ended.
template <class Piece>
void run(std::size_t pieces, const Piece& piece) {
    std::atomic<std::size_t> next{0};
    std::mutex failing;
    std::exception_ptr failure;
    const auto work = [&] {
        // Relaxed: taking a piece must not look like waiting for the one before.
        for (std::size_t i = 0; (i = next.fetch_add(1, std::memory_order_relaxed)) < pieces;) {
            try {
                piece(i);
            } catch (...) {
                const std::lock_guard lock(failing);
                if (!failure) failure = std::current_exception();
            }
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t t = 1; t < std::min(pieces, allowed_threads()); ++t)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace sanitized

/// As oneTBB's, in pieces of the range's grain size.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
    const std::size_t grain = range.grainsize();
    sanitized::run((range.size() + grain - 1) / grain, [&](std::size_t i) {
        const std::size_t begin = i * grain, end = std::min(begin + grain, range.size());
        body(blocked_range<Value>(range.begin() + static_cast<Value>(begin),
                                  range.begin() + static_cast<Value>(end), grain));
    });
}

/// As oneTBB's, in up to 64 pieces.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
    if (!(first < last)) return;
    const std::size_t count = static_cast<std::size_t>(last - first);
    const std::size_t grain = (count + 63) / 64;
    parallel_for(blocked_range<std::size_t>(0, count, grain),
                 [&](const blocked_range<std::size_t>& range) {
                     for (std::size_t i = range.begin(); i < range.end(); ++i)
                         body(static_cast<Index>(first + static_cast<Index>(i)));
                 });
}

}  // namespace tbb
