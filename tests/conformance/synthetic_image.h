// Images of known difference and known noise.
#pragma once

#include <cstdint>

#include "rendered_image.h"

namespace conformance {

/// A smooth image of positive colours, 120 x 90.
render::Image smooth_image();

/// `image` times `factor`, each pixel with independent Gaussian noise of `sigma` times its value.
render::Image noisy(const render::Image& image, double factor, double sigma, std::uint64_t seed);

}  // namespace conformance
