// Sums on all threads that round alike for any number of them.
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel_for.h"

namespace aips {

/// Sum of part_of(first, last) over ranges that make up [0, count): their size is fixed, and they
/// are joined by += in order.
template <class Part, class PartOf>
Part ordered_sum(std::size_t count, const PartOf& part_of) {
    std::vector<Part> parts((count + kItemsPerJob - 1) / kItemsPerJob);
    in_chunks(count, kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        parts[first / kItemsPerJob] = part_of(first, last);
    });
    Part sum{};
    for (const Part& part : parts)
        sum += part;
    return sum;
}

}  // namespace aips
