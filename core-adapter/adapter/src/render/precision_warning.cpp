// Distance between floats against pixel footprints.
#include "render/precision_warning.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "render/constants.h"

namespace aips {
namespace {

/// Part of a pixel to which positions may be rounded at what is seen before the log warns of it.
constexpr double kMostOfPixel = 0.25;

double mean_step(const std::vector<VisiblePoint>& points) {
    double sum = 0;
    for (const VisiblePoint& point : points) {
        const Vec3 p = abs(point.position);
        sum += double(std::max({p.x, p.y, p.z})) * 0x1p-23;
    }
    return sum / double(points.size());
}

}  // namespace

void warn_of_lost_precision(const EyeImage& image, Log& log) {
    if (image.visible_points.empty()) return;
    const double step = mean_step(image.visible_points), pixel = 2 * image.mean_footprint();
    if (!(pixel > 0) || !(step > kMostOfPixel * pixel)) return;
    std::ostringstream text;
    text.precision(2);
    text << "positions are rounded to " << step << " units where a pixel sees " << pixel
         << ": what is seen is too small for its distance from the origin";
    log.warning(text.str());
}

}  // namespace aips
