// Images whose error is known.
#pragma once

#include <functional>
#include <random>

#include "error_metrics.h"

namespace bench::test {

/// width x height pixels, all channels of a pixel being value(x, y).
Image synthetic_image(int width, int height, const std::function<double(int, int)>& value);

/// Every channel of every pixel is `mean` plus a normal deviate times `deviation`.
Image noisy_image(int width, int height, double mean, double deviation, std::mt19937& random);

}  // namespace bench::test
