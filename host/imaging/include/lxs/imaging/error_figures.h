// One figure for a whole image: its estimated error.
#pragma once

#include <cstdint>
#include <vector>

#include "lxs/imaging/error_estimate.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// An image, and what is known of its error: width * height entries, row by row.
struct UncertainImage {
    std::uint32_t width = 0, height = 0;
    std::vector<Rgb> value = {};     ///< the mean over passes, not below zero
    std::vector<Rgb> variance = {};  ///< of the mean; 0 where it was cut at zero
    /// Squares of what errs beside noise, right in the mean, so that some are below zero; empty if
    /// they aren't known pixel by pixel.
    std::vector<Rgb> squared_bias = {};
    /// In its place, what it adds to relMSE and to MSE.
    double relmse_of_bias = 0, mse_of_bias = 0;
    /// About as many independent squares as each variance rests on.
    double degrees_of_freedom = 1;
};

/// Estimates what docs/measured/method.md defines: relMSE, with epsilon, here without the worst
/// 0.1 % of the pixels of each, and MSE. The true image that relMSE divides by is not known. Where
/// a pixel is not surely different from the mean of those around it, by its own variance, it is
/// taken to be as they are: a single bright path would else make its own pixel count for little.
/// Squared biases are added where their mean over all pixels is more than 0.
ErrorEstimate estimate_error(const UncertainImage& image);

}  // namespace lxs
