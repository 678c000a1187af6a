// Counts values that are no light: not finite, or negative where that makes no sense.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <string_view>

#include "lxs/sdk/types.h"

namespace lxs {

/// Counts from many threads, by the name of the texture that gave the value ("": none has a name).
class RefusedValues {
  public:
    using Totals = std::map<std::string, std::uint64_t, std::less<>>;

    void count(std::string_view texture) {
        {
            const std::shared_lock lock(mutex_);
            const auto known = counts_.find(texture);
            if (known != counts_.end()) {
                known->second.fetch_add(1, std::memory_order_relaxed);
                return;
            }
        }
        const std::unique_lock lock(mutex_);
        ++counts_[std::string(texture)];
    }
    Totals totals() const {
        const std::shared_lock lock(mutex_);
        return {counts_.begin(), counts_.end()};
    }
    /// Only while nobody counts.
    void set_totals(const Totals& totals) {
        counts_.clear();
        for (const auto& [texture, total] : totals)
            counts_[texture] = total;
    }

  private:
    mutable std::shared_mutex mutex_;
    std::map<std::string, std::atomic<std::uint64_t>, std::less<>> counts_;
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
