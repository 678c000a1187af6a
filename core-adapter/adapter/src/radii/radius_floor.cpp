// Radii that single precision asks for.
#include "radii/radius_floor.h"

namespace aips {

void raise_to_floor(const EyeImage& image, const RadiusFloor& floor, float radius,
                    std::vector<float>& radii) {
    radii.clear();
    const auto& points = image.visible_points;
    const auto is_below = [&](const VisiblePoint& p) { return radius < floor.at(p.position); };
    if (std::none_of(points.begin(), points.end(), is_below)) return;
    radii.reserve(points.size());
    for (const VisiblePoint& point : points)
        radii.push_back(std::max(radius, floor.at(point.position)));
}

}  // namespace aips
