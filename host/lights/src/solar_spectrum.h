// Colour of sunlight: solar spectrum, attenuated by the atmosphere, as linear RGB.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

/// Colour of the sun's disk seen through the atmosphere, its luminance in cd m^-2, for
/// a sun `cos_zenith` = cosine of its zenith angle and a `turbidity` from 1 (Preetham, Shirley &
/// Smits 1999, appendix A.2). Black below the horizon.
Rgb sun_radiance(double cos_zenith, double turbidity);

}  // namespace lxs
