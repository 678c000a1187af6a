// Sums by index, of which most threads or blocks touch few: they grow to what is counted.
#pragma once

#include <cstddef>
#include <vector>

namespace aips {

/// The entry `index`; entries up to it are made if they are not there yet.
template <class T>
T& sum_at(std::vector<T>& sums, std::size_t index) {
    if (index >= sums.size()) sums.resize(index + 1);
    return sums[index];
}

/// Adds `other` entry by entry.
template <class T>
void add_sums(std::vector<T>& sums, const std::vector<T>& other) {
    if (sums.size() < other.size()) sums.resize(other.size());
    for (std::size_t i = 0; i < other.size(); ++i)
        sums[i] += other[i];
}

}  // namespace aips
