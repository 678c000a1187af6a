// How the core runs independent jobs: it has no threads of its own, its caller may lend some.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace aips {

/// One of several jobs, by number. Jobs do not depend on each other's order.
using Job = std::function<void(std::uint32_t)>;

/// Runs job(0) ... job(count - 1), each once, on any number of threads, and returns when all are
/// done.
using ParallelFor = std::function<void(std::uint32_t count, const Job& job)>;

/// A ParallelFor that uses the calling thread alone.
inline void serial_for(std::uint32_t count, const Job& job) {
    for (std::uint32_t i = 0; i < count; ++i)
        job(i);
}

/// Runs work(first, last) over [0, count) in chunks of `chunk`, fewer than 2^32 of them.
template <class Work>
void in_chunks(std::size_t count, std::size_t chunk, const ParallelFor& parallel, Work&& work) {
    parallel(static_cast<std::uint32_t>((count + chunk - 1) / chunk), [&](std::uint32_t i) {
        const std::size_t first = i * chunk;
        work(first, std::min(first + chunk, count));
    });
}

}  // namespace aips
