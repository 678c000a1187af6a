// Radii that single precision asks for.
#include "radii/radius_floor.h"

#include <atomic>

#include "base/assign_all.h"

namespace aips {

void raise_to_floor(const EyeImage& image, const RadiusFloor& floor, float radius,
                    std::vector<float>& radii) {
    const auto& points = image.visible_points;
    const auto in_points = [&](const auto& work) {
        in_chunks(points.size(), kItemsPerJob, tbb_for, work);
    };
    std::atomic<bool> any_below = false;
    in_points([&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (radius < floor.at(points[i].position))
                any_below.store(true, std::memory_order_relaxed);
        }
    });
    if (!any_below) {
        radii.clear();
        return;
    }
    reserve_with_room(radii, points.size(), image.positions.size());
    radii.resize(points.size());
    in_points([&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            radii[i] = std::max(radius, floor.at(points[i].position));
    });
}

}  // namespace aips
