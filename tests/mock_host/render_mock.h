// Renders mock scenes with the engine; common ground of the adapter's tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aips/adapter/engine.h"
#include "mock_camera.h"
#include "mock_scene.h"

namespace mock {

/// A rendered image and what the engine says of it.
struct Rendering {
    Film film;
    aips::EngineStatistics statistics;
    Log log;
};

/// Renders `passes` passes of `scene`.
Rendering render(const aips::Scene& scene, const Camera& camera, std::uint32_t width,
                 std::uint32_t height, const aips::Settings& settings, std::uint32_t passes);

/// Radii of the first `passes` passes of `scene` onto an image of 16 x 16.
std::vector<float> radii(const Scene& scene, const aips::Settings& settings, unsigned passes);

/// "none", "paper" or "adaptive".
std::string name(aips::GuideKind guide);

/// Luminance of every pixel, row by row.
std::vector<double> luminances(const Film& film);

/// Mean luminance of a w x h image inside the rectangle [x0, x1) x [y0, y1).
double mean_luminance(const std::vector<aips::Rgb>& image, std::uint32_t width, std::uint32_t x0,
                      std::uint32_t y0, std::uint32_t x1, std::uint32_t y1);

/// Settings for small test renders: unguided, progressive, a fixed radius (alpha 1) if asked for.
/// A guide that is asked for guides: no pilot pass leaves it out.
aips::Settings small_settings(std::uint64_t seed, std::uint32_t photons);

/// A camera at `eye` looking along +y with z up, image plane half-width `half` at distance 1.
Camera camera_along_y(aips::Vec3 eye, float half, std::uint32_t width, std::uint32_t height);

/// The default Lambert lobe, and a mirror that reflects 0.3.
Material half_mirror();

/// A scene and where it is seen from.
struct View {
    Scene scene;
    Camera camera;
};

/// lamp_box with white walls and a ball of half_mirror, seen from its front.
View half_mirror_view(std::uint32_t width, std::uint32_t height);

/// A patch of 0.8 x 0.6 in the middle of a floor of half width `half` under a lamp as wide: few
/// photon paths reach it. A wall beside the patch brings light of two bounces.
View wide_view(float half, std::uint32_t width, std::uint32_t height);

/// A sheet that is diffuse on both sides; if `shiny`, with a glossy and a mirror lobe as well.
Material sheet(bool shiny);

/// A white box [-1,1]^3 that a sheet of `divider` divides, its shading normals tilted by 3 degrees:
/// the lamp is on the left, both sides are seen. With `outshone` another lamp has as many times its
/// power, sealed in a black box beside the room.
View divided_view(std::uint32_t width, std::uint32_t height, const Material& divider,
                  float outshone);

/// A white box [-1,1]^3 with a quad lamp under its ceiling and a matte ball on its floor.
Scene lamp_box(const Material& wall, const Material& ball);

}  // namespace mock
