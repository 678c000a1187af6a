// Pixel maps from images on disk, and as pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "error_metrics.h"
#include "pixel_map.h"

namespace bench {

/// Channel LAYER.Y of an EXR file; nothing if it has no such layer. Throws StudyError if the file
/// can't be read.
std::optional<PixelMap> read_map(const std::filesystem::path& file, const std::string& layer);

/// Rec. 709 luminance.
PixelMap luminance_map(const Image& image);

/// The value that `share` (0 to 1) of the pixels don't exceed.
double quantile(const PixelMap& map, double share);

/// Grey PNG: (value / white)^(1 / 2.2), clamped; black if `white` is 0. Makes the folder. Throws
/// lxs::OutputFailure.
void write_picture(const std::filesystem::path& file, const PixelMap& map, double white);

}  // namespace bench
