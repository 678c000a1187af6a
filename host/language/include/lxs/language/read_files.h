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

/// Larger sources are not kept for the lines that messages show: a mesh that is written out in one
/// may be most of a scene's memory.
inline constexpr std::size_t kMostKeptText = std::size_t{16} << 20;

/// Forgets the sources, and the text of those above kMostKeptText: messages about them show the
/// place, but not the line.
void forget_sources(ReadFiles& files);

}  // namespace lxs
