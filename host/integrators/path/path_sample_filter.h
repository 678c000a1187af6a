// The invalid-sample filter of paths: what is no light, and where it arose.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>

#include "lxs/sdk/invalid_samples.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// Finite and not negative.
inline bool valid(const Rgb& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && c.x >= 0 && c.y >= 0 &&
           c.z >= 0;
}
/// Likewise a density, or a power.
inline bool valid_density(float value) {
    return value >= 0 && std::isfinite(value);
}
inline bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Counts invalid samples from many threads. Each `accept` tells whether its value may be used, and
/// counts it if not.
class PathSampleFilter {
  public:
    /// `scene` outlives it.
    explicit PathSampleFilter(const Scene& scene);

    bool accept_of_material(bool usable, std::uint32_t material);
    bool accept_of_light(bool usable, const Light& light);
    /// Media, and surfaces that light passes straight.
    bool accept_of_passage(bool usable);

    std::uint64_t total() const;
    /// By origin; those without any are left out.
    InvalidSampleList list() const;
    /// Saves or restores the counts.
    void state(StateArchive& archive);

  private:
    bool accept(bool usable, std::size_t index);

    const Scene& scene_;
    std::size_t materials_, lights_;
    std::unique_ptr<std::atomic<std::uint64_t>[]> counts_;  // materials, lights, passage
};

}  // namespace lxs
