// Growth of vectors whose final size is bounded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aips {

/// Makes room for `needed` elements: doubling, but never beyond `most` >= needed.
template <class T>
void grow_capacity(std::vector<T>& vector, std::size_t needed, std::size_t most) {
    if (vector.capacity() >= needed) return;
    vector.reserve(std::min(most, std::max(needed, 2 * vector.capacity())));
}

}  // namespace aips
