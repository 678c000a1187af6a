// Layers that are parts of the image.
#include "sum_to_image.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace lxs {

void sum_to_image(std::span<ColorLayer> parts, std::span<const Rgb> image) {
    if (parts.empty()) return;
    tbb::parallel_for(std::size_t{0}, image.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) {
            double sum = 0;
            for (const ColorLayer& part : parts)
                sum += double{part.values[i][c]};
            const double whole = image[i][c];
            const double factor = whole / sum;
            if (std::isfinite(factor)) {
                for (ColorLayer& part : parts)
                    part.values[i][c] = static_cast<float>(part.values[i][c] * factor);
            } else {
                parts.front().values[i][c] = static_cast<float>(whole);
            }
        }
    });
}

}  // namespace lxs
