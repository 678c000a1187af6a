// Runs work on a chosen number of threads, whatever number of processors the machine has.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace concurrency {

/// Result of `work` (called without arguments), whose parallel loops have `count` (> 0) threads.
/// The limit alone would leave them no more than the machine has processors, the arena alone those
/// that the process allows.
template <typename Work>
auto run_on(unsigned count, const Work& work) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    tbb::task_arena arena(static_cast<int>(count));
    return arena.execute(work);
}

}  // namespace concurrency
