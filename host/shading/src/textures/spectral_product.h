// The spectrum of a product of colours.
#pragma once

#include "lxs/scene/texture.h"

namespace lxs::shading {

/// Null unless both are the same everywhere and at least one has a spectrum; of the other one it
/// takes the spectrum that stands for its colour.
CurvePointer spectral_product(const ColorTexture& first, const ColorTexture& second);

}  // namespace lxs::shading
