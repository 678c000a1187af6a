// Stands in for oneTBB's header of this name in builds with AIPS_RECORD_WORK: every parallel loop
// of the engine and the host passes here, and is recorded (docs/measured/scaling.md). What is built
// without that option knows nothing of it.
#pragma once

#include <tbb/blocked_range.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <typeinfo>

#include "work_record.h"

namespace tbb {
namespace recorded {

/// The type whose name tells the function that a loop is in.
template <class Body>
const std::type_info& name_of(const Body& /*body*/) {
    return typeid(Body);
}
template <class... Arguments>
const std::type_info& name_of(const std::function<void(Arguments...)>& job) {
    return job.target_type();
}

}  // namespace recorded

/// As oneTBB's.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
    const work_record::Loop loop{recorded::name_of(body), range.size(), range.grainsize()};
    work_record::run(loop, [&](std::size_t first, std::size_t last) {
        body(blocked_range<Value>(range.begin() + static_cast<Value>(first),
                                  range.begin() + static_cast<Value>(last), range.grainsize()));
    });
}

/// As oneTBB's.
template <std::integral Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
    if (!(first < last)) return;
    const work_record::Loop loop{recorded::name_of(body), static_cast<std::size_t>(last - first),
                                 1};
    work_record::run(loop, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            body(static_cast<Index>(first + static_cast<Index>(i)));
    });
}

}  // namespace tbb
