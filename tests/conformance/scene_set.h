// The scenes that are compared: NAME.lxs beside NAME.exr in one folder, and how close they must be.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "block_comparison.h"

namespace conformance {

struct Scene {
    std::string name;
    std::filesystem::path file;
    std::filesystem::path reference;  ///< linear radiance
    Spread limit;                     ///< relative differences above it are a miss
};

/// How far the scene `name` may be from its reference: 2 % in the median block, 6 % in the 95th
/// percentile; 10 % there for rough glass, whose references keep fireflies (two runs of LuxRender
/// differ by 6.5 %).
Spread limit_for(const std::string& name);

/// Scenes with a reference in `folder`, by name; of `names` alone unless that is empty. Throws
/// std::runtime_error for a name that isn't there.
std::vector<Scene> scenes_in(const std::filesystem::path& folder,
                             const std::vector<std::string>& names);

}  // namespace conformance
