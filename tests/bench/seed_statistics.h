// What the images of several seeds say about a method: bias and variance apart.
#pragma once

#include <span>

#include "error_metrics.h"

namespace bench {

/// Averages over pixels and channels; bias2 + variance is the expected mse of one seed.
struct SeedStatistics {
    double bias2 = 0;         ///< radiance^2; unbiased, so noise may make it negative
    double variance = 0;      ///< of one seed's image, radiance^2
    double rel_bias2 = 0;     ///< each pixel divided by R1 R2 + epsilon
    double rel_variance = 0;  ///< likewise
};

/// Mean of images of equal size, at least one.
Image mean_image(std::span<const Image> images);

/// Of at least two images of equal size; throws std::invalid_argument for fewer.
SeedStatistics seed_statistics(std::span<const Image> images, const Image& first,
                               const Image& second);

}  // namespace bench
