// Images as planes of one number a pixel, and means over squares of pixels.
#include "planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lxs::denoising {

Colors planes_of(std::span<const Rgb> image) {
    Colors planes;
    for (int c = 0; c < 3; ++c) {
        Plane& plane = planes[static_cast<std::size_t>(c)];
        plane.resize(image.size());
        std::transform(image.begin(), image.end(), plane.begin(),
                       [c](const Rgb& v) { return std::isfinite(v[c]) ? v[c] : 0.0f; });
    }
    return planes;
}

Plane finite(std::span<const float> values) {
    Plane plane(values.size());
    std::transform(values.begin(), values.end(), plane.begin(),
                   [](float v) { return std::isfinite(v) ? v : 0.0f; });
    return plane;
}

Plane mean_around(const Plane& plane, Size size) {
    Plane means(plane.size());
    tbb::parallel_for(std::uint32_t{0}, size.height, [&](std::uint32_t y) {
        const std::uint32_t top = y - std::min(y, 1u), bottom = std::min(y + 1, size.height - 1);
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const std::uint32_t left = x - std::min(x, 1u), right = std::min(x + 1, size.width - 1);
            float sum = 0;
            for (std::uint32_t v = top; v <= bottom; ++v) {
                const float* const row = &plane[std::size_t{v} * size.width];
                for (std::uint32_t u = left; u <= right; ++u)
                    sum += row[u];
            }
            const auto count = static_cast<float>((bottom - top + 1) * (right - left + 1));
            means[std::size_t{y} * size.width + x] = sum / count;
        }
    });
    return means;
}

}  // namespace lxs::denoising
