// Every plugin that the host makes from a statement: its parameters, and one use of what is made.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace fuzz {

struct PluginUse {
    std::string name;
    std::vector<lxs::ParameterDeclaration> declared;
    /// Throws InputError.
    std::function<void(const lxs::ParameterSet&)> make_and_use;
};

/// Shapes, textures, materials, media, lights, cameras, films, filters and samplers, by kind and
/// name.
std::vector<PluginUse> plugin_uses();

}  // namespace fuzz
