// Invalid samples: not finite, or negative.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lxs {

/// Values of one origin that were refused: 'material "red"', 'light 3 (area)', 'light group "sky"'.
struct InvalidSamples {
    std::string origin;
    std::uint64_t count = 0;
};

using InvalidSampleList = std::vector<InvalidSamples>;

}  // namespace lxs
