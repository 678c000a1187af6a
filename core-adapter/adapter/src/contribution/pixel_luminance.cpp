// Luminances of eye paths.
#include "contribution/pixel_luminance.h"

#include "base/film_pixel.h"
#include "base/parallel_for.h"

namespace aips {

void pixel_luminances(const EyeImage& image, std::span<const Rgb> photons, std::uint32_t width,
                      std::uint32_t height, std::vector<PixelLuminance>& seen) {
    seen.resize(image.positions.size());
    in_chunks(seen.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t path = first; path < last; ++path) {
            seen[path] = {double(luminance_over_groups(image.radiance, path, image.groups)) +
                              double(luminance_over_groups(photons, path, image.groups)),
                          film_pixel(image.positions[path], width, height)};
        }
    });
}

void add_emitter_rests(const EyeImage& image, std::span<PixelLuminance> seen) {
    for (const EmitterRest& rest : image.emitter_rests)
        seen[rest.sample].luminance += double(rest.luminance);
}

}  // namespace aips
