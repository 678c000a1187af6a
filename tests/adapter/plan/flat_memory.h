// Whether an engine's memory stays within its bound and flat from pass to pass.
#pragma once

#include <cstdint>

#include "aips/adapter/engine.h"
#include "mock_camera.h"
#include "mock_scene.h"

namespace mock {

/// Expects that after `settled` passes and 24 more memory is within the bound stated at the start,
/// and that the 24 add at most 2 %. Returns the statistics after the last.
aips::EngineStatistics expect_flat_memory(const Scene& scene, const aips::Camera& camera,
                                          std::uint32_t width, std::uint32_t height,
                                          const aips::Settings& settings, unsigned settled = 6);

}  // namespace mock
