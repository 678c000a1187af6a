// Optical constants per channel that give a metal the colour that its spectrum has.
#pragma once

#include "optical_table.h"

namespace lxs::shading {

/// Share reflected by a metal of index `n` and extinction `k` under the cosine `c` as LuxRender
/// has it: an approximation for n^2 + k^2 well above 1, within 1.5 % of the exact formula for
/// silver, gold, copper and aluminium, 4 % for carbon.
double metal_reflectance(double c, double n, double k);

/// Index and extinction for R, G and B whose exact Fresnel reflectance (fresnel_conductor) is, for
/// all angles, nearest to the colour of the table's reflectance under a white lamp; channels above
/// 1, as gold's red, are cut off. A table without extinction in visible light, a dielectric, gives
/// its indices at the wavelengths that stand for R, G and B, and one that doesn't vary its
/// constants.
FresnelValue constants_of_colour(const OpticalTable& table);

}  // namespace lxs::shading
