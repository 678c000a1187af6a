// Images of known difference and known noise.
#include "synthetic_image.h"

#include <cmath>
#include <random>

namespace conformance {

render::Image smooth_image() {
    render::Image image{120, 90, {}};
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < image.width; ++x) {
            const double value = 1.5 + std::sin(0.05 * double(x)) * std::cos(0.07 * double(y));
            for (const double color : {0.9, 1.0, 0.4})
                image.rgb.push_back(float(color * value));
        }
    }
    return image;
}

render::Image noisy(const render::Image& image, double factor, double sigma, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, sigma);
    render::Image result = image;
    for (std::size_t i = 0; i < result.rgb.size(); i += 3) {
        const double scale = factor * (1 + normal(engine));
        for (std::size_t c = 0; c < 3; ++c)
            result.rgb[i + c] = float(double(result.rgb[i + c]) * scale);
    }
    return result;
}

}  // namespace conformance
