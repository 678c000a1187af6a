// Lights of emissive surfaces, instanced ones included.
#pragma once

#include <memory>
#include <vector>

#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"

namespace lxs {

/// Appends a light per emissive primitive to `lights`, in the order of `primitives`, and the same
/// to `table`, which hits look up by Surface::emissive_index. A dark one, for want
/// of an area, is warned of.
void append_area_lights(const std::vector<Primitive>& primitives, const Matrix& instance_to_world,
                        std::vector<std::unique_ptr<PlacedLight>>& lights,
                        std::vector<const AreaLight*>& table, Diagnostics& diagnostics);

}  // namespace lxs
