// Error of an image against two independent references, whose own noise cancels.
#include "error_metrics.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

namespace algo = OIIO::ImageBufAlgo;

void check_same_size(const Image& a, const Image& b) {
    if (a.spec().width != b.spec().width || a.spec().height != b.spec().height ||
        a.nchannels() != b.nchannels()) {
        throw std::invalid_argument("images differ in size");
    }
}

/// Sums over the pixels, one for each channel.
std::vector<double> channel_means(const Image& image) {
    const auto pixels = double(image.spec().image_pixels());
    std::vector<double> means = algo::computePixelStats(image).sum;
    for (double& mean : means)
        mean /= pixels;
    return means;
}

std::vector<float> mean_over_channels(const Image& image) {
    const auto channels = std::size_t(image.nchannels());
    std::vector<float> values(image.spec().image_pixels() * channels);
    image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, values.data());
    std::vector<float> means(image.spec().image_pixels());
    for (std::size_t i = 0; i < means.size(); ++i) {
        const float* pixel = values.data() + i * channels;
        means[i] = std::accumulate(pixel, pixel + channels, 0.0f) / float(channels);
    }
    return means;
}

/// Fills `worst` and `relmse_rest`.
void part_worst(const Image& relative, ImageError& error) {
    std::vector<float> errors = mean_over_channels(relative);
    const auto pixels = std::max<std::size_t>(1, std::size_t(kWorstShare * double(errors.size())));
    const auto end = errors.begin() + std::ptrdiff_t(pixels);
    std::nth_element(errors.begin(), end - 1, errors.end(),
                     [](float a, float b) { return std::abs(a) > std::abs(b); });
    const double worst = std::accumulate(errors.begin(), end, 0.0);
    const double rest = std::accumulate(end, errors.end(), 0.0);
    error.worst.pixels = pixels;
    error.worst.relmse = worst / double(pixels);
    error.worst.share = worst + rest > 0 ? worst / (worst + rest) : 0;
    if (errors.size() > pixels) error.relmse_rest = rest / double(errors.size() - pixels);
}

}  // namespace

double mean_value(const Image& image) {
    const std::vector<double> means = channel_means(image);
    return std::accumulate(means.begin(), means.end(), 0.0) / double(means.size());
}

double mean_luminance(const Image& image) {
    const std::vector<double> means = channel_means(image);
    return 0.2126 * means.at(0) + 0.7152 * means.at(1) + 0.0722 * means.at(2);
}

Image error_product(const Image& a, const Image& first, const Image& second) {
    return algo::mul(algo::sub(a, first), algo::sub(a, second));
}

double relative_epsilon(const Image& first, const Image& second) {
    const double luminance = (mean_luminance(first) + mean_luminance(second)) / 2;
    return std::max(1e-4 * luminance * luminance, double(std::numeric_limits<float>::min()));
}

Image relative_to(const Image& squares, const Image& first, const Image& second, double epsilon) {
    return algo::div(squares, algo::add(algo::mul(first, second), float(epsilon)));
}

ImageError measure_error(const Image& image, const Image& first, const Image& second) {
    check_same_size(image, first);
    check_same_size(image, second);
    const Image product = error_product(image, first, second);
    ImageError error;
    error.epsilon = relative_epsilon(first, second);
    error.mse = mean_value(product);
    error.rmse = std::sqrt(std::max(0.0, error.mse));
    const Image relative = relative_to(product, first, second, error.epsilon);
    error.relmse = mean_value(relative);
    part_worst(relative, error);
    return error;
}

}  // namespace bench
