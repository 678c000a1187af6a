// Which pixels a film has.
#pragma once

#include <cstdint>

namespace lxs {

/// The image and the window of it that is rendered, pixels.
struct FilmFrame {
    std::uint32_t x_resolution = 800, y_resolution = 600;
    std::uint32_t x = 0, y = 0;  ///< upper left pixel of the window
    std::uint32_t width = 800, height = 600;
};

/// Most pixels of an image (16384 x 8192). The film's sums take 8 + 24 bytes per light group and
/// pixel: 4.3 GB for this many with one group, and as much again where passes have a second part.
inline constexpr std::uint64_t kMaxFilmPixels = std::uint64_t{1} << 27;

}  // namespace lxs
