// Work on the rows of an image, many at once.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>

namespace lxs {

template <class Work>
void for_rows(std::uint32_t height, const Work& work) {
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& rows) {
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y)
            work(y);
    });
}

}  // namespace lxs
