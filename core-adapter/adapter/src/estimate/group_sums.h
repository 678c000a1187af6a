// Sums over photons, by light group, as one gather makes them at one place.
//
// Many photons of equal power are what single precision sums worst: a million of them are off by a
// percent, and from 2^24 on they count for nothing. In double n photons are off by n 2^-53 at most,
// relative to the sum. What a gather has found is added to single precision once: over a pass of G
// gathers that leaves an error of G 2^-24, and a gather takes a million photons.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "aips/core/base/rgb.h"

namespace aips {

class GroupSums {
  public:
    explicit GroupSums(std::uint32_t groups) : sums_(3 * std::size_t{groups}) {}

    void add(std::uint32_t group, Rgb value) {
        double* const sum = &sums_[3 * std::size_t{group}];
        sum[0] += double(value.r);
        sum[1] += double(value.g);
        sum[2] += double(value.b);
    }
    void scale(double factor) {
        for (double& sum : sums_)
            sum *= factor;
    }
    /// Adds what was summed to `flux`, group by group, and starts anew.
    void move_to(Rgb* flux) {
        for (std::size_t i = 0; i < sums_.size(); i += 3) {
            Rgb& to = flux[i / 3];
            to = {float(double(to.r) + sums_[i]), float(double(to.g) + sums_[i + 1]),
                  float(double(to.b) + sums_[i + 2])};
            sums_[i] = sums_[i + 1] = sums_[i + 2] = 0;
        }
    }

  private:
    std::vector<double> sums_;  // [3 * group + component]
};

/// Adds to `sum` the variance of `light`, a luminance made of photons that come independently:
/// theirs sum to `brought`, the squares of theirs to `squares`. Nothing where it is not finite.
inline void add_variance(float& sum, double light, double brought, float squares) {
    if (!(brought > 0)) return;
    const double share = light / brought;
    const auto raised = float(double(sum) + share * share * double(squares));
    if (std::isfinite(raised)) sum = raised;
}

/// A count that stays at the largest number instead of starting again at 0.
inline std::uint32_t saturated_sum(std::uint32_t a, std::uint64_t b) {
    const std::uint64_t most = std::numeric_limits<std::uint32_t>::max() - a;
    return b < most ? a + static_cast<std::uint32_t>(b) : std::numeric_limits<std::uint32_t>::max();
}

}  // namespace aips
