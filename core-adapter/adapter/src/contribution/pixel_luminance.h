// What the eye paths of a pass saw, photons included, and in which pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eye/eye_pass.h"

namespace aips {

struct PixelLuminance {
    double luminance = 0;     ///< over all light groups
    std::uint32_t pixel = 0;  ///< number (film_pixel.h)
};

/// Fills `seen` with an entry for each eye path of `image`, to which photons brought `photons`, one
/// entry for each eye path and light group; reuses the memory.
void pixel_luminances(const EyeImage& image, std::span<const Rgb> photons, std::uint32_t width,
                      std::uint32_t height, std::vector<PixelLuminance>& seen);

/// Adds what eye paths left to emitter paths: it belongs to how bright pixels are, not to their
/// noise.
void add_emitter_rests(const EyeImage& image, std::span<PixelLuminance> seen);

}  // namespace aips
