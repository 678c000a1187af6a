// A reference image as it grows: the weighted mean of chunks, and how they spread.
#pragma once

#include <cstddef>

#include "error_metrics.h"

namespace bench {

/// Mean of independent chunks whose variance goes with 1 / weight. Any number of channels.
struct WeightedImage {
    Image mean;
    Image squares;  ///< sum over chunks of weight x (chunk - mean)^2
    double weight = 0;
    std::size_t chunks = 0;
};

/// `weight` > 0 is the work in the image: photon paths or samples per pixel.
WeightedImage one_chunk(const Image& image, double weight);

/// As if the chunks of both had been put into one (Chan, Golub and LeVeque 1979, weighted).
WeightedImage merge(const WeightedImage& a, const WeightedImage& b);

/// Of the mean, in each pixel and channel: sqrt(squares / ((chunks - 1) weight)); 0 with one chunk,
/// when there is nothing to tell it by.
Image standard_error(const WeightedImage& image);

/// What `standard_error` was made from.
WeightedImage restore(const Image& mean, const Image& standard_error, double weight,
                      std::size_t chunks);

}  // namespace bench
