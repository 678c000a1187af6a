// Pixel maps from images, and as pictures.
#pragma once

#include <filesystem>

#include "error_metrics.h"
#include "pixel_map.h"

namespace bench {

/// Rec. 709 luminance.
PixelMap luminance_map(const Image& image);

/// Grey PNG: (value / white)^(1 / 2.2), clamped; black if `white` is 0. Makes the folder. Throws
/// lxs::OutputFailure.
void write_picture(const std::filesystem::path& file, const PixelMap& map, double white);

}  // namespace bench
