// Images whose error is known.
#include "synthetic_image.h"

#include <array>

namespace bench::test {

Image synthetic_image(int width, int height, const std::function<double(int, int)>& value) {
    Image image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto v = float(value(x, y));
            const std::array pixel{v, v, v};
            image.setpixel(x, y, pixel);
        }
    }
    return image;
}

Image noisy_image(int width, int height, double mean, double deviation, std::mt19937& random) {
    std::normal_distribution<float> normal{float(mean), float(deviation)};
    Image image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::array pixel{normal(random), normal(random), normal(random)};
            image.setpixel(x, y, pixel);
        }
    }
    return image;
}

}  // namespace bench::test
