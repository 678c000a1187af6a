// Names of the layers that a user may ask for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/sdk/layers.h"

namespace lxs {

/// Names of a scene's "layers" and of --layers, `all` among them.
std::span<const std::string_view> layer_names();

/// The layers that `names` ask for; throws std::invalid_argument for one that is unknown, saying
/// which are known.
LayersWanted layers_named(std::span<const std::string> names);

/// The parts of a text such as "albedo,depth", empty ones left out.
std::vector<std::string> split_layer_names(std::string_view text);

}  // namespace lxs
