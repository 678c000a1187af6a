// Winsorised sum of footprints.
#include "eye/footprints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "eye/constants.h"

namespace aips {

double bounded_footprint_sum(std::span<float> footprints) {
    const auto finite = [](float footprint) { return std::isfinite(footprint); };
    footprints = footprints.first(std::size_t(
        std::partition(footprints.begin(), footprints.end(), finite) - footprints.begin()));
    if (footprints.empty()) return 0;
    const auto middle = footprints.begin() + static_cast<std::ptrdiff_t>(footprints.size() / 2);
    std::nth_element(footprints.begin(), middle, footprints.end());
    // A median of zero bounds nothing: such a camera has no footprints for most of its pixels.
    const float most =
        *middle > 0 ? kMostMedians * *middle : std::numeric_limits<float>::infinity();
    double sum = 0;
    for (const float footprint : footprints)
        sum += double(std::min(footprint, most));
    return sum;
}

}  // namespace aips
