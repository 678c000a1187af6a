// Sums of many places, in parallel and each in the order of what is added.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "aips/core/base/parallel.h"

namespace aips {

/// Of items that are left out.
inline constexpr std::uint32_t kNoOwner = std::numeric_limits<std::uint32_t>::max();

/// Calls add(i) once for each item with an owner: for the items of one owner in their order, for
/// those of others at the same time. Every job looks at all owners and takes its part of them.
template <class Add>
void in_order_by_owner(std::span<const std::uint32_t> owners, const ParallelFor& parallel,
                       const Add& add) {
    constexpr std::uint32_t kJobs = 32;
    parallel(kJobs, [&](std::uint32_t job) {
        for (std::size_t i = 0; i < owners.size(); ++i) {
            if (owners[i] != kNoOwner && owners[i] % kJobs == job) add(i);
        }
    });
}

}  // namespace aips
