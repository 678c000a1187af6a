// The invalid-sample filter: keeps out what is not finite or negative, and counts it by origin.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/base/state_archive.h"

namespace aips {

/// What a contribution is counted against: a material's index as it is, or of_light(), or
/// kPassageOrigin.
using Origin = std::uint32_t;

/// Origin of what dims light on its way: media, and surfaces that it passes straight.
inline constexpr Origin kPassageOrigin = ~Origin{0};

/// True for what may be a density or a power.
inline bool is_valid_density(float value) {
    return value >= 0 && std::isfinite(value);
}

/// Keeps invalid contributions out of a render and counts them. That is rare, so integer atomics
/// are good enough.
class InvalidSampleFilter {
  public:
    /// Of one material without a name.
    InvalidSampleFilter();
    /// `scene` outlives this.
    explicit InvalidSampleFilter(const Scene& scene);

    Origin of_light(LightIndex light) const { return materials_ + light; }

    /// True if `value` may enter the image; else counts it against `origin`.
    bool accept(const Rgb& value, Origin origin) {
        if (is_valid_radiance(value)) return true;
        count(origin);
        return false;
    }
    /// Likewise of a density, or of a power.
    bool accept_density(float value, Origin origin) {
        if (is_valid_density(value)) return true;
        count(origin);
        return false;
    }
    bool accept_direction(Vec3 direction, Origin origin) {
        if (is_finite(direction)) return true;
        count(origin);
        return false;
    }
    /// What a light says of the way to it.
    bool accept_sample(const DirectSample& sample, LightIndex light) {
        if (is_valid_radiance(sample.radiance) && is_valid_density(sample.pdf) &&
            is_finite(sample.wi)) {
            return true;
        }
        count(of_light(light));
        return false;
    }
    /// Adds `value` to a valid sum if the sum then still is valid; else counts it, and returns
    /// false.
    bool add(Rgb& sum, const Rgb& value, Origin origin) {
        const Rgb raised = sum + value;
        if (!accept(value, origin) || !accept(raised, origin)) return false;
        sum = raised;
        return true;
    }
    void count(Origin origin, std::uint64_t times = 1);
    /// Counts by origin: materials, lights, then passage; count() takes the same numbers.
    std::vector<std::uint64_t> counts() const;

    /// Saves or restores the counts.
    void state(StateArchive& archive);

    std::uint64_t total() const;
    /// (origin, count) of all that had a contribution refused: materials first, then lights.
    std::vector<std::pair<std::string, std::uint64_t>> by_origin() const;

  private:
    std::string name_of(std::size_t index) const;

    const Scene* scene_ = nullptr;
    std::uint32_t materials_ = 1, lights_ = 0;
    std::unique_ptr<std::atomic<std::uint64_t>[]> counts_;  // materials, lights, passage
};

}  // namespace aips
