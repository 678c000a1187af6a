// Counts values that are no light: not finite, or negative where that makes no sense.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

/// Counts from many threads. Counting is rare.
class RefusedValues {
  public:
    void count() { count_.fetch_add(1, std::memory_order_relaxed); }
    std::uint64_t total() const { return count_.load(std::memory_order_relaxed); }
    /// Only while nobody counts.
    void set_total(std::uint64_t total) { count_.store(total, std::memory_order_relaxed); }

  private:
    std::atomic<std::uint64_t> count_{0};
};

inline bool is_finite(float v) {
    return std::isfinite(v);
}
inline bool is_finite(const Rgb& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}
inline bool is_negative(const Rgb& c) {
    return c.x < 0 || c.y < 0 || c.z < 0;
}

}  // namespace lxs
