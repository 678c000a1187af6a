// Kinds of cloth by LuxRender's names.
#pragma once

#include <string_view>

#include "bent_yarn.h"
#include "lxs/sdk/parameters.h"
#include "weave.h"

namespace lxs::shading {

struct ClothPreset {
    std::string_view name, weave_name;
    Weave weave;
    Yarn warp, weft;
};

/// The preset "presetname", with a warning of what of it is a stand-in; the default one
/// for an unknown name, with a warning of that.
const ClothPreset& read_cloth_preset(const ParameterReader& reader);

}  // namespace lxs::shading
