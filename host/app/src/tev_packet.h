// Packets of the viewer tev's protocol.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs::tev {

/// A new image with channels R, G and B, all black, in front of others.
std::string create_image(std::string_view name, std::uint32_t width, std::uint32_t height);
/// All pixels of it. `pixels`: row by row.
std::string update_image(std::string_view name, std::uint32_t width, std::uint32_t height,
                         std::span<const Rgb> pixels);

}  // namespace lxs::tev
