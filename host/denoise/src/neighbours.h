// Which pixels around are averaged with a pixel.
#pragma once

#include <vector>

#include "planes.h"

namespace lxs::denoising {

struct Guide {
    Plane value, variance;
    float least;
};

/// Compares pixels by one half of the passes.
struct Judge {
    Size size;
    Colors mean, variance;
    const std::vector<Guide>* guides;
};

/// Averages `image` with weights that `judge` gives; of one size. Pixels beyond the image's edges
/// count nowhere. A pixel always counts for itself.
Colors average_alike(const Judge& judge, const Colors& image);

}  // namespace lxs::denoising
