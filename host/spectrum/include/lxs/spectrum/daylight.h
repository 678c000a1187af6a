// White light: the illuminant that a colour of (1, 1, 1) stands for in a light.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

/// Standard illuminant D65 at `nm` nanometres, scaled to luminance 1: its integral against the
/// eye's sensitivity is that of a flat spectrum of 1.
double daylight(double nm);

/// What white light of `nm` nanometres adds to R, G and B, per nanometre, scaled such that each
/// channel sums to 1 over the visible range. Against it, spectra relative to white light have their
/// colours: radiances divided by daylight(), reflectances and transmittances as they are.
Imath::V3d daylight_response(double nm);

}  // namespace lxs
