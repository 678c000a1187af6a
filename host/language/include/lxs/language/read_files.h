// Which files a scene was read from.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Everything that the reader has opened for a scene, in the order in which it did.
struct ReadFiles {
    std::vector<std::shared_ptr<const SourceFile>> sources;  ///< the main file and its includes
    std::vector<std::string> assets;  ///< paths of meshes, textures and the like; some twice
};

}  // namespace lxs
