// Lights of the mock host.
#pragma once

#include <memory>

#include "mock_scene.h"

namespace mock {

std::unique_ptr<aips::Light> make_quad_light(const Quad& quad, aips::Rgb radiance,
                                             std::uint32_t group);
/// Sampled over its whole area.
std::unique_ptr<aips::Light> make_ball_light(const Ball& ball, aips::Rgb radiance,
                                             std::uint32_t group);
std::unique_ptr<aips::Light> make_point_light(aips::Vec3 position, aips::Rgb intensity);
std::unique_ptr<aips::Light> make_distant_light(const aips::Bounds& bounds, const DistantCone& cone,
                                                aips::Rgb radiance);

}  // namespace mock
