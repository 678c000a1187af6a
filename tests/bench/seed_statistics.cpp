// What the images of several seeds say about a method: bias and variance apart.
#include "seed_statistics.h"

#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

namespace bench {

namespace algo = OIIO::ImageBufAlgo;

Image mean_image(std::span<const Image> images) {
    Image sum = images.front();
    for (const Image& image : images.subspan(1))
        sum = algo::add(sum, image);
    return algo::mul(sum, 1.0f / float(images.size()));
}

namespace {

Image sample_variance(std::span<const Image> images, const Image& mean) {
    Image sum;
    for (const Image& image : images) {
        const Image difference = algo::sub(image, mean);
        const Image square = algo::mul(difference, difference);
        sum = sum.initialized() ? algo::add(sum, square) : square;
    }
    return algo::mul(sum, 1.0f / float(images.size() - 1));
}

}  // namespace

SeedStatistics seed_statistics(std::span<const Image> images, const Image& first,
                               const Image& second) {
    if (images.size() < 2) throw std::invalid_argument("seed statistics need two images");
    const Image mean = mean_image(images);
    const Image variance = sample_variance(images, mean);
    const Image product = error_product(mean, first, second);
    const double epsilon = relative_epsilon(first, second);
    const auto seeds = double(images.size());
    SeedStatistics statistics;
    statistics.variance = mean_value(variance);
    statistics.bias2 = mean_value(product) - statistics.variance / seeds;
    statistics.rel_variance = mean_value(relative_to(variance, first, second, epsilon));
    statistics.rel_bias2 =
        mean_value(relative_to(product, first, second, epsilon)) - statistics.rel_variance / seeds;
    return statistics;
}

}  // namespace bench
