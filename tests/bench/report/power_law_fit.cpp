// How fast errors fall: the slope of a straight line through points in log time and log error.
#include "power_law_fit.h"

#include <cmath>

namespace bench {

std::optional<PowerLaw> fit_power_law(std::span<const CurvePoint> curve) {
    double count = 0, mean_x = 0, mean_y = 0;
    for (const CurvePoint& point : curve) {
        if (point.error <= 0) continue;
        ++count;
        mean_x += (std::log(point.seconds) - mean_x) / count;
        mean_y += (std::log(point.error) - mean_y) / count;
    }
    double xx = 0, xy = 0;
    for (const CurvePoint& point : curve) {
        if (point.error <= 0) continue;
        const double x = std::log(point.seconds) - mean_x;
        xx += x * x;
        xy += x * (std::log(point.error) - mean_y);
    }
    if (count < 2 || xx <= 0) return std::nullopt;
    const double slope = xy / xx;
    return PowerLaw{slope, std::exp(mean_y - slope * mean_x)};
}

}  // namespace bench
