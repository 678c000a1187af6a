// Warns where pixels see less than positions can say.
#pragma once

#include "aips/adapter/camera.h"
#include "eye/eye_pass.h"

namespace aips {

/// One warning to `log` if, on the mean over the visible points, neighbouring floats at their
/// coordinates lie farther apart than a quarter of a pixel: edges, shadows and caustics there are
/// then ragged, whatever the photons.
void warn_of_lost_precision(const EyeImage& image, Log& log);

}  // namespace aips
