// A room as a scene file in any unit of length and at any place.
#pragma once

#include <array>
#include <string>

namespace stress {

/// Where the room stands and how large it is. All lengths and the places of all vertices, spheres,
/// lamps and the camera follow; intensities follow so that radiance stays.
struct Placement {
    double scale = 1;                ///< scene units per unit of the room, which is 2 wide
    std::array<double, 3> origin{};  ///< the middle of its floor, scene units
    std::array<double, 2> hither_yon{1e-3, 1e4};  ///< camera clipping, units of the room
};

/// The text of the scene: a box of three colours, a matte ball (an instance scaled by its
/// transform), a glass ball, a lamp under the ceiling and a point light. `size` is the image's
/// width and height.
std::string scaled_room(const Placement& placement, int size);

}  // namespace stress
