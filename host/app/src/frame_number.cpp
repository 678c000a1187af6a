// Which frame of an animation a scene file is.
#include "lxs/host/frame_number.h"

#include <filesystem>

namespace lxs {

std::optional<std::uint32_t> frame_number(const std::string& scene) {
    constexpr const char* kDigits = "0123456789";
    constexpr std::size_t kMostDigits = 9;
    const std::string name = std::filesystem::path(scene).stem().string();
    const std::size_t last = name.find_last_of(kDigits);
    if (last == std::string::npos) return std::nullopt;
    const std::size_t before = name.find_last_not_of(kDigits, last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    if (last - first >= kMostDigits) return std::nullopt;
    return static_cast<std::uint32_t>(std::stoul(name.substr(first, last - first + 1)));
}

}  // namespace lxs
