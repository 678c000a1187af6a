// What every light carries besides its emission.
#pragma once

#include <cstdint>
#include <memory>

#include "lxs/sdk/medium.h"

namespace lxs {

struct LightPlacement {
    std::uint32_t group = 0;               ///< light group, index into the scene's names
    std::shared_ptr<const Medium> medium;  ///< that emitted light travels in; null for vacuum
    bool hidden = false;                   ///< the camera does not see it
};

}  // namespace lxs
