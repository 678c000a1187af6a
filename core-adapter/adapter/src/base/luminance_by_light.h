// Luminance by the light that it came from.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/adapter/transport_statistics.h"
#include "aips/core/base/state_archive.h"
#include "base/growing_sums.h"

namespace aips {

/// Index of a light among those that transport statistics tell apart.
inline std::uint32_t told_light(LightIndex light) {
    return std::min(light, kMostToldLights - 1);
}

class LuminanceByLight {
  public:
    void add(LightIndex light, double luminance) { sum_at(sums_, told_light(light)) += luminance; }
    void add(const LuminanceByLight& other, double factor = 1) {
        if (sums_.size() < other.sums_.size()) sums_.resize(other.sums_.size());
        for (std::size_t i = 0; i < other.sums_.size(); ++i)
            sums_[i] += factor * other.sums_[i];
    }
    void clear() { sums_.clear(); }
    const std::vector<double>& sums() const { return sums_; }

    /// Saves or restores the sums.
    void state(StateArchive& archive) {
        archive.values(sums_);
        StateArchive::check(sums_.size() <= kMostToldLights, "more lights than are told apart");
        for (double& sum : sums_)
            archive.check(sum >= 0 && sum < std::numeric_limits<double>::infinity(),
                          "luminance that is none");
    }

  private:
    std::vector<double> sums_;  // [light]
};

/// Adds a luminance to `sums`, unless they are null.
inline void tell(LuminanceByLight* sums, LightIndex light, float luminance) {
    if (sums && luminance > 0) sums->add(light, double(luminance));
}

}  // namespace aips
