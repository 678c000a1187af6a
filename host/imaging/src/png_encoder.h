// PNG files in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lxs {

/// The bytes of an 8-bit PNG of width * height interleaved pixels, for a display of this gamma.
/// `alpha`, one a pixel from 0 to 1, makes it RGBA: colours are then not multiplied by it, as the
/// format has them. Throws std::runtime_error with libpng's reason.
std::vector<std::byte> encode_png(std::uint32_t width, std::uint32_t height, double gamma,
                                  std::span<const std::uint8_t> rgb,
                                  std::span<const float> alpha = {});

}  // namespace lxs
