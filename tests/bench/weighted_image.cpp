// A reference image as it grows: the weighted mean of chunks, and how they spread.
#include "weighted_image.h"

#include <OpenImageIO/imagebufalgo.h>

namespace bench {
namespace {
namespace algo = OIIO::ImageBufAlgo;

/// Degrees of freedom times weight: what turns squares into a squared standard error.
double divisor(double weight, std::size_t chunks) {
    return (double(chunks) - 1) * weight;
}
}  // namespace

WeightedImage one_chunk(const Image& image, double weight) {
    return {image, algo::mul(image, 0.0f), weight, 1};
}

WeightedImage merge(const WeightedImage& a, const WeightedImage& b) {
    WeightedImage both;
    both.weight = a.weight + b.weight;
    both.chunks = a.chunks + b.chunks;
    const double share = b.weight / both.weight;
    const Image difference = algo::sub(b.mean, a.mean);
    both.mean = algo::add(a.mean, algo::mul(difference, float(share)));
    both.squares = algo::add(algo::add(a.squares, b.squares),
                             algo::mul(algo::mul(difference, difference), float(a.weight * share)));
    return both;
}

Image standard_error(const WeightedImage& image) {
    if (image.chunks < 2) return algo::mul(image.mean, 0.0f);
    const double scale = 1 / divisor(image.weight, image.chunks);
    return algo::pow(algo::mul(image.squares, float(scale)), 0.5f);
}

WeightedImage restore(const Image& mean, const Image& standard_error, double weight,
                      std::size_t chunks) {
    const Image square = algo::mul(standard_error, standard_error);
    const double scale = chunks < 2 ? 0 : divisor(weight, chunks);
    return {mean, algo::mul(square, float(scale)), weight, chunks};
}

}  // namespace bench
