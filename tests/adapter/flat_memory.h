// Whether an engine's memory stays within its bound and flat from pass to pass.
#pragma once

#include <cstdint>

#include "aips/adapter/engine.h"
#include "mock_camera.h"
#include "mock_scene.h"

namespace mock {

/// Expects of 30 passes that the memory after the last is within the bound stated at the start and
/// at most 2 % above that after the sixth. Returns the statistics after the last.
aips::EngineStatistics expect_flat_memory(const Scene& scene, const Camera& camera,
                                          std::uint32_t width, std::uint32_t height,
                                          const aips::Settings& settings);

}  // namespace mock
