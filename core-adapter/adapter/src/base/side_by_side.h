// Work beside other work.
#pragma once

#include <tbb/parallel_invoke.h>

namespace aips {

/// Runs first() and second(), which know nothing of each other, at the same time on all threads,
/// and returns when both have ended.
template <class First, class Second>
void side_by_side(const First& first, const Second& second) {
    tbb::parallel_invoke(first, second);
}

}  // namespace aips
