// What is around each pixel of an image.
#include "means_around.h"

#include <algorithm>
#include <cstddef>

#include "for_rows.h"

namespace lxs {
namespace {

/// Pixels to either side whose mean stands for what is around one. Unit: pixels. Balances: pixels
/// enough that single bright paths do not matter against those of another surface. Chosen by: how
/// often the estimate is within 1.5 of the true one, 73 % with 4, 67 % with 2, 52 % with the median
/// of 2. Supported by: the same page.
constexpr std::uint32_t kReach = 4;

/// Sums of up to 2 kReach + 1 pixels in a row; in a fixed order.
std::vector<Imath::V3d> sums_along_rows(const std::vector<Rgb>& image, std::uint32_t width,
                                        std::uint32_t height) {
    std::vector<Imath::V3d> sums(image.size(), Imath::V3d(0.0));
    for_rows(height, [&](std::uint32_t y) {
        const std::size_t row = std::size_t{y} * width;
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::uint32_t last = std::min(x + kReach, width - 1);
            for (std::uint32_t i = x - std::min(x, kReach); i <= last; ++i)
                sums[row + x] += Imath::V3d(image[row + i]);
        }
    });
    return sums;
}

}  // namespace

std::vector<Rgb> means_around(const std::vector<Rgb>& image, std::uint32_t width,
                              std::uint32_t height) {
    const std::vector<Imath::V3d> sums = sums_along_rows(image, width, height);
    std::vector<Rgb> means(image.size(), Rgb(0.0f));
    for_rows(height, [&](std::uint32_t y) {
        const std::uint32_t top = y - std::min(y, kReach);
        const std::uint32_t rows = std::min(y + kReach, height - 1) - top + 1;
        for (std::uint32_t x = 0; x < width; ++x) {
            Imath::V3d sum(0.0);
            for (std::uint32_t row = top; row < top + rows; ++row)
                sum += sums[std::size_t{row} * width + x];
            const std::uint32_t left = x - std::min(x, kReach);
            const std::uint32_t columns = std::min(x + kReach, width - 1) - left + 1;
            const std::size_t i = std::size_t{y} * width + x;
            const double others = static_cast<double>(columns) * rows - 1;
            if (others > 0) means[i] = Rgb((sum - Imath::V3d(image[i])) / others);
        }
    });
    return means;
}

}  // namespace lxs
