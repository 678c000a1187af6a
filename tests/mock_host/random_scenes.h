// Random small scenes for tests of expectations: each is a pure function of its number.
#pragma once

#include <cstdint>

#include "render_mock.h"

namespace mock {

/// Kinds of scenes that random_view draws.
struct RandomSceneKind {
    /// Open rooms lack a wall and the ceiling, stand on a wide ground, may be lit from infinity.
    bool open = false;
    /// No glass, no glossy lobes, white mirrors on which photons land (a black diffuse lobe), and a
    /// black ball around all: what is absorbed is known in closed form, and what escapes lands too.
    bool accountable = false;
    /// Walls and objects all have a diffuse lobe and a mirror.
    bool half_mirrors = false;
    /// Lamps in the place of point lights: rays that bounce off mirrors meet every light.
    bool no_points = false;
};

/// A room of matte walls within [-1,1]^3 with one to three objects (balls, boxes, panels; matte,
/// half mirror, mirror, glass, glossy) and one to three lights (quads, balls, points, and in open
/// rooms suns and skies), whose powers range over 1 : 1000. The camera stands free in the room; at
/// least half of what it sees are receivers in direct light, and no lamp is before it.
View random_view(std::uint64_t number, const RandomSceneKind& kind, std::uint32_t width,
                 std::uint32_t height);

}  // namespace mock
