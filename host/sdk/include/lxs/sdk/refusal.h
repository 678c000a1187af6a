// What was refused because it is no light: not finite, or negative.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lxs {

/// Values of one origin that were refused: 'material "red"', 'light 3 (area)', 'light group "sky"'.
struct Refusal {
    std::string origin;
    std::uint64_t count = 0;
};

using RefusalList = std::vector<Refusal>;

}  // namespace lxs
