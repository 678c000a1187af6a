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

}  // namespace aips
