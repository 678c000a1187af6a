// How the core runs independent jobs: it has no threads of its own, its caller may lend some.
#pragma once

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

}  // namespace aips
