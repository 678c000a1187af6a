// Sums by key on all threads, each in the order of its items.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/parallel_for.h"

namespace aips {

/// Items one after the other, and the keys among them.
struct KeyedPiece {
    std::size_t first = 0;
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t greatest = 0;

    void add(std::uint32_t key) {
        least = std::min(least, key);
        greatest = std::max(greatest, key);
    }
};

/// Where ranges of at least kItemsPerJob / 2 items begin, and where the last ends: of `pieces`,
/// which make up [0, count), as many as have no key in common with those of other ranges.
inline std::vector<std::size_t> disjoint_begins(const std::vector<KeyedPiece>& pieces,
                                                std::size_t count) {
    std::vector<std::uint32_t> least_from(pieces.size());
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), greatest = 0;
    for (std::size_t p = pieces.size(); p-- > 0;)
        least_from[p] = least = std::min(least, pieces[p].least);
    std::vector<std::size_t> begins{0};
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const std::size_t first = pieces[p].first;
        if (p > 0 && least_from[p] > greatest && first - begins.back() >= kItemsPerJob / 2)
            begins.push_back(first);
        greatest = std::max(greatest, pieces[p].greatest);
    }
    begins.push_back(count);
    return begins;
}

/// Calls work(first, last) for ranges that make up [0, count), on all threads, no two of which have
/// a key_of(item) in common: what is summed by key is summed in the order of the items. There are
/// many where keys rise with the items, as the pixels of eye paths do; else one.
template <class KeyOf, class Work>
void in_disjoint_ranges(std::size_t count, const KeyOf& key_of, const Work& work) {
    // Two a chunk: keys that hold for longer, such as rows, seldom change where a chunk begins.
    std::vector<KeyedPiece> pieces(2 * ((count + kItemsPerJob - 1) / kItemsPerJob));
    in_chunks(count, kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        KeyedPiece& before = pieces[2 * (first / kItemsPerJob)];
        KeyedPiece& after = pieces[2 * (first / kItemsPerJob) + 1];
        const std::uint32_t key = key_of(first);
        std::size_t i = first;
        before.first = first;
        for (; i < last && key_of(i) == key; ++i) {
        }
        before.add(key);
        after.first = i;
        for (; i < last; ++i)
            after.add(key_of(i));
    });
    const std::vector<std::size_t> begins = disjoint_begins(pieces, count);
    tbb_for(std::uint32_t(begins.size() - 1),
            [&](std::uint32_t i) { work(begins[i], begins[i + 1]); });
}

}  // namespace aips
