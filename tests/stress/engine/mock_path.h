// A plain path tracer on the engine's view of a scene: the reference that shares no photon with it.
#pragma once

#include <cstdint>
#include <vector>

#include "mock_camera.h"

namespace stress {

/// Luminance of each pixel, row by row, from `samples` paths a pixel with shadow rays at broad
/// lobes (no multiple importance sampling). Light from points and other deltas by way of mirrors or
/// glass is missing.
std::vector<double> path_traced(const aips::Scene& scene, const mock::Camera& camera,
                                std::uint32_t width, std::uint32_t height, std::uint32_t samples,
                                std::uint64_t seed);

}  // namespace stress
