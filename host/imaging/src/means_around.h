// What is around each pixel of an image.
#pragma once

#include <cstdint>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Per pixel the mean of the 9 x 9 around it, as far as they are on the film, itself left out. The
/// same bits for any number of threads.
std::vector<Rgb> means_around(const std::vector<Rgb>& image, std::uint32_t width,
                              std::uint32_t height);

}  // namespace lxs
