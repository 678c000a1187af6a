// Vectors filled on all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel_for.h"

namespace aips {

/// Takes memory for `count` values where there is too little, and for a few more up to `most`: of
/// counts that differ from pass to pass each new greatest would move all of them.
template <class T>
void reserve_with_room(std::vector<T>& values, std::size_t count, std::size_t most) {
    if (values.capacity() >= count) return;
    values.reserve(std::max(count, std::min(most, count + count / 32)));
}

/// As values.assign(count, value). Grows no further than to `most` values, or to `count` if that is
/// more.
template <class T>
void assign_all(std::vector<T>& values, std::size_t count, const T& value, std::size_t most = 0) {
    const std::size_t kept = std::min(values.size(), count);
    reserve_with_room(values, count, most);
    values.resize(count, value);
    in_chunks(kept, kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), last - first, value);
    });
}

}  // namespace aips
