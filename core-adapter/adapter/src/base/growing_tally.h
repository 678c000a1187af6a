// Tallies by index, of which most threads or blocks touch few: they grow to what is counted.
#pragma once

#include <cstddef>
#include <vector>

namespace aips {

/// The entry `index`; entries up to it are made if they are not there yet.
template <class T>
T& tally_at(std::vector<T>& tallies, std::size_t index) {
    if (index >= tallies.size()) tallies.resize(index + 1);
    return tallies[index];
}

/// Adds `other` entry by entry.
template <class T>
void add_tallies(std::vector<T>& tallies, const std::vector<T>& other) {
    if (tallies.size() < other.size()) tallies.resize(other.size());
    for (std::size_t i = 0; i < other.size(); ++i)
        tallies[i] += other[i];
}

}  // namespace aips
