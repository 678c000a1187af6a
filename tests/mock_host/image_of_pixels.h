// An eye image for tests of what is kept for each pixel.
#pragma once

#include "contribution/pixel_luminance.h"
#include "eye/eye_pass.h"

namespace mock {

/// One eye path in the middle of each pixel, row by row, each with a visible point; all see
/// `radiance` in each light group.
inline aips::EyeImage image_of_pixels(std::uint32_t width, std::uint32_t height, aips::Rgb radiance,
                                      std::uint32_t groups = 1) {
    aips::EyeImage image;
    image.groups = groups;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            aips::VisiblePoint point;
            point.sample = static_cast<std::uint32_t>(image.positions.size());
            image.visible_points.push_back(point);
            image.positions.push_back({float(x) + 0.5f, float(y) + 0.5f});
        }
    }
    image.radiance.assign(image.positions.size() * groups, radiance);
    return image;
}

/// What its eye paths saw when photons brought `photons` to them.
inline std::vector<aips::PixelLuminance> seen_pixels(const aips::EyeImage& image,
                                                     std::span<const aips::Rgb> photons,
                                                     std::uint32_t width, std::uint32_t height) {
    std::vector<aips::PixelLuminance> seen;
    aips::pixel_luminances(image, photons, width, height, seen);
    return seen;
}

}  // namespace mock
