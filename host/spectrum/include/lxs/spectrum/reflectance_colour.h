// Colours of reflectances as LuxRender renders them under its white light.
//
// LuxRender turns a surface's RGB into a spectrum (rgb_spectra.h) and lights it with that of a
// white lamp, so that a saturated colour comes back a little other than it was written.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

/// What light of `nm` nanometres of LuxRender's white lamps adds to R, G and B, per nanometre,
/// scaled such that each channel sums to 1 over the visible range at steps of 1 nm. Against it a
/// spectral reflectance has the colour that a white lamp shows of it.
Imath::V3d white_lamp_response(double nm);

/// The colour that a reflectance or transmittance of LuxRender has which a scene writes as `rgb`:
/// greys as they are; components may be a little below the least or above the greatest of `rgb`,
/// and below 0. Linear where the order of the components stays the same.
Rgb colour_of_reflectance(const Rgb& rgb);

/// The reflectance to write so that its colour is `seen`, none of whose components is negative; as
/// near as components of 0 or more come to it.
Rgb reflectance_of_colour(const Rgb& seen);

}  // namespace lxs
