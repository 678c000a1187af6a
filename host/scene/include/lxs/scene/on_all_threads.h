// Loops over the elements of large meshes on all threads, whose results don't depend on their
// number.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>

namespace lxs {

/// Elements that one thread takes at a time: some 50 us of work, against some us to give it out.
inline constexpr std::size_t kElementsAtOnce = 1 << 13;

/// Calls work(begin, end) for pieces of [0, count), each element in one of them.
template <class Work>
void in_pieces(std::size_t count, const Work& work) {
    if (count <= kElementsAtOnce) {
        work(std::size_t{0}, count);
        return;
    }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, kElementsAtOnce),
        [&](const tbb::blocked_range<std::size_t>& piece) { work(piece.begin(), piece.end()); });
}

/// The first of the numbers below `count` that `is` holds for, or `count`. `is` is asked for each
/// number before it once, and perhaps for some behind it.
template <class Is>
std::size_t first_where(std::size_t count, const Is& is) {
    std::atomic<std::size_t> first{count};
    in_pieces(count, [&](std::size_t begin, std::size_t end) {
        if (begin > first.load(std::memory_order_relaxed)) return;
        for (std::size_t i = begin; i < end; ++i) {
            if (!is(i)) continue;
            std::size_t known = first.load(std::memory_order_relaxed);
            while (i < known && !first.compare_exchange_weak(known, i, std::memory_order_relaxed))
                continue;
            return;
        }
    });
    return first.load();
}

}  // namespace lxs
