// The response curves that the Film statement asks for.
#pragma once

#include <memory>

#include "camera_response.h"
#include "lxs/imaging/imaging.h"

namespace lxs {

/// Curves of the file that "cameraresponse" names; null without one. As in LuxRender, a file that
/// is missing or holds no curves is a warning, at its place in the file, and no curve is applied.
std::shared_ptr<const CameraResponse> choose_camera_response(const SceneContents& contents,
                                                             Diagnostics& diagnostics,
                                                             const FileResolver& resolve);

}  // namespace lxs
