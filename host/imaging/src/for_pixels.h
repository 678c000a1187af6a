// A loop over pixels on all threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace lxs {

/// Calls work(pixel) for each of them once, in any order; for work of some nanoseconds a pixel.
template <class Work>
void for_pixels(std::size_t pixels, const Work& work) {
    constexpr std::size_t kPixels = 1024;  // of a task
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels, kPixels), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            work(i);
    });
}

}  // namespace lxs
