// The threads that the adapter lends to the core.
#pragma once

#include <tbb/parallel_for.h>

#include "aips/core/base/parallel.h"

namespace aips {

/// Of cheap items that one job takes: some ten microseconds.
inline constexpr std::size_t kItemsPerJob = std::size_t(1) << 11;

/// A ParallelFor on TBB's threads.
inline void tbb_for(std::uint32_t count, const Job& job) {
    tbb::parallel_for(0u, count, job);
}

/// work(i) for each i below `count`, many in a job.
template <class Work>
void for_all(std::size_t count, const Work& work) {
    in_chunks(count, kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            work(i);
    });
}

}  // namespace aips
