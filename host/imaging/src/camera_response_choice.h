// The response curves that the Film statement asks for.
#pragma once

#include <memory>

#include "camera_response.h"
#include "film_settings.h"
#include "lxs/imaging/imaging.h"

namespace lxs {

/// Curves of the file that "cameraresponse" names; null without one. As in LuxRender, where a file
/// is missing or holds no curves no curve is applied.
std::shared_ptr<const CameraResponse> choose_camera_response(const FilmSettings& settings,
                                                             Diagnostics& diagnostics,
                                                             const FileResolver& resolve);

}  // namespace lxs
