// The medium plugins, one factory each.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

MediumFactory clear_plugin();
MediumFactory homogeneous_plugin();

}  // namespace lxs::shading
