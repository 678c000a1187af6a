// Measured media by the names that pbrt has for them.
#pragma once

#include <optional>
#include <string_view>

#include "lxs/sdk/types.h"

namespace lxs::pbrt {

/// Per millimetre, linear RGB; of scattering the reduced coefficient.
struct MediumPreset {
    Rgb scattering, absorption;
};

std::optional<MediumPreset> medium_preset(std::string_view name);

}  // namespace lxs::pbrt
