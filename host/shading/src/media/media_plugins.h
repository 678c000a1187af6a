// The medium plugins, one factory each.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

MediumFactory clear_plugin();
MediumFactory homogeneous_plugin();
MediumFactory heterogeneous_plugin();

}  // namespace lxs::shading
