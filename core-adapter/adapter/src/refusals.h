// Counts contributions that are not finite or negative, by the material where they arose.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "aips/core/rgb.h"
#include "aips/core/state_archive.h"

namespace aips {

/// Refused contributions of a render. Counting is rare, so integer atomics are good enough.
class Refusals {
  public:
    explicit Refusals(std::span<const std::string> material_names);

    /// True if `value` may enter the image; else counts it against `material`.
    bool accept(const Rgb& value, std::uint32_t material) {
        if (is_valid_radiance(value)) return true;
        count(material);
        return false;
    }
    void count(std::uint32_t material);

    /// Saves or restores the counts.
    void state(StateArchive& archive);

    std::uint64_t total() const;
    /// (material name, count) of every material that had a contribution refused.
    std::vector<std::pair<std::string, std::uint64_t>> by_material() const;

  private:
    std::vector<std::string> names_;  // one per material, then "(light)"
    std::unique_ptr<std::atomic<std::uint64_t>[]> counts_;
};

/// Material index under which contributions of lights are counted.
inline constexpr std::uint32_t kLightOrigin = ~std::uint32_t{0};

}  // namespace aips
