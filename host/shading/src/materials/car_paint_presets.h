// Car paints by LuxRender's names.
#pragma once

#include <string_view>

#include "bsdfs/car_paint_bsdf.h"
#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// The preset that LuxRender's defaults are, and that stands in for unknown ones.
inline constexpr std::string_view kDefaultCarPaint = "ford f8";

/// Paint that the preset "name" is; null if "name" is absent, empty or "-" (the paint's own
/// parameters count). Warns of an unknown name.
const CarPaint* read_car_paint_preset(const ParameterReader& reader);

/// Paint of the preset `name`, which must exist; for defaults.
const CarPaint& car_paint_preset(std::string_view name);

}  // namespace lxs::shading
