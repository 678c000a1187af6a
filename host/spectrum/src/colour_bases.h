// The spectra of which LuxRender makes those of colours, as tables.
#pragma once

#include <array>

#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {

inline constexpr double kBaseFirstNm = 380, kBaseLastNm = 720;

/// Values at equal steps from kBaseFirstNm to kBaseLastNm, linear in between, 0 beyond.
using SpectralBase = std::array<double, 32>;

/// As LuxRender 1.9 tabulates them, before their scale: a reflectance of 1 is
/// kReflectanceScale times its white. The scale of lights is that of luminance.
extern const std::array<SpectralBase, kColourBases> kReflectanceBases, kIlluminantBases;
inline constexpr double kReflectanceScale = 0.94112876;

}  // namespace lxs
