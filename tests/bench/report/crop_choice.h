// Which part of a scene's images a report magnifies.
#pragma once

#include <span>

#include "display_image.h"

namespace bench {

struct CropSize {
    int width_px = 0, height_px = 0;
};

/// The crop in which what is shown of `images` differs most from what is shown of `truth`: sum over
/// pixels, channels and images of the absolute difference of 8-bit values. No image counts for more
/// than another, so that the choice favours none. The crop is at most three fifths of the image
/// each way (but whole sides below 24 pixels).
Crop choose_crop(std::span<const Image* const> images, const Image& truth, const ToneMap& map,
                 const CropSize& size);

inline constexpr int kOverviewWidth = 240;
/// Of an overview in landscape format, about.
inline constexpr double kOverviewPixels = 240.0 * 180.0;

/// The whole image, tone-mapped after being made at most kOverviewWidth pixels wide.
DisplayImage overview(const Image& image, const ToneMap& map);

}  // namespace bench
