// Stands in for oneTBB's header of this name in builds with the thread sanitizer, as parallel_for.h
// does.
#pragma once

#include <cstddef>

#include "parallel_for.h"

namespace tbb {

/// As oneTBB's, of two.
template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    sanitized::run(2, [&](std::size_t i) {
        if (i == 0) {
            first();
        } else {
            second();
        }
    });
}

}  // namespace tbb
