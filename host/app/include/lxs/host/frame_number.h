// Which frame of an animation a scene file is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lxs {

/// The last number in the file's name without folder and ending: 7 of "shots/2_frame_0007.lxs".
/// None if there is none, or one of more than nine digits.
std::optional<std::uint32_t> frame_number(const std::string& scene);

}  // namespace lxs
