// Mean and largest of many radii.
#include "estimate/gather_radii.h"

#include "base/ordered_sum.h"

namespace aips {
namespace {

struct RadiusSums {
    float largest = 0;
    double sum = 0;

    RadiusSums& operator+=(const RadiusSums& other) {
        largest = std::max(largest, other.largest);
        sum += other.sum;
        return *this;
    }
};

}  // namespace

GatherRadii::GatherRadii(std::span<const float> radii) : per_point(radii) {
    const auto sums_of = [&](std::size_t first, std::size_t last) {
        RadiusSums sums;
        for (const float radius : radii.subspan(first, last - first))
            sums += {radius, double(radius)};
        return sums;
    };
    const auto sums = ordered_sum<RadiusSums>(radii.size(), sums_of);
    largest = sums.largest;
    mean = float(sums.sum / double(radii.size()));
}

}  // namespace aips
