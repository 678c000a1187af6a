// Car paints by LuxRender's names.
#pragma once

#include <string_view>

#include "bsdfs/car_paint_bsdf.h"
#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// Paint that stands for the preset "name"; null if "name" is absent, empty or "-" (the paint's own
/// parameters count). Throws InputError for an unknown name. Warns where the preset is a stand-in.
const CarPaint* read_car_paint_preset(const ParameterReader& reader);

/// Paint of the preset `name`, which must exist; for defaults.
const CarPaint& car_paint_preset(std::string_view name);

}  // namespace lxs::shading
