// What one eye pass sees of a mock scene.
#pragma once

#include "eye/eye_pass.h"
#include "mock_camera.h"
#include "mock_scene.h"

namespace mock {

/// The first pass, of `paths` eye paths over size x size pixels. Lights are chosen by power. With
/// `shares` eye paths go on from visible points.
aips::EyeImage traced_eye_image(const Scene& scene, const Camera& camera, std::uint32_t size,
                                std::uint32_t paths, const aips::Settings& settings,
                                const aips::EyeShares* shares = nullptr);

}  // namespace mock
