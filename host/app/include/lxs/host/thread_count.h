// How many threads this process works with.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace lxs {

/// Result of `work` (called without arguments), whose parallel loops have `threads` threads, also
/// more than there are processors; 0: one for each processor. The limit is the process's.
template <typename Work>
auto on_threads(unsigned threads, const Work& work) {
    if (threads == 0) return work();
    // Either alone gives less: a limit is cut to the processors, an arena to the limit.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    return arena.execute(work);
}

}  // namespace lxs
