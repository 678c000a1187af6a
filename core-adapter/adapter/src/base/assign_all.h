// Vectors filled on all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel_for.h"

namespace aips {

/// As values.assign(count, value), which grows no further than that either.
template <class T>
void assign_all(std::vector<T>& values, std::size_t count, const T& value) {
    const std::size_t kept = std::min(values.size(), count);
    values.reserve(count);
    values.resize(count, value);
    in_chunks(kept, kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), last - first, value);
    });
}

}  // namespace aips
