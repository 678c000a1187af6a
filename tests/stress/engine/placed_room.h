// A closed room of the mock host in any unit of length, at any place, with lamps of any strength.
#pragma once

#include "render_mock.h"

namespace stress {

/// How the room differs from one of [-1,1]^3 with lamps of about 10 watts per square metre.
struct RoomPlace {
    float scale = 1;      ///< scene units per unit of the room; lamps follow, radiance stays
    aips::Vec3 middle{};  ///< of the room, scene units
    float strength = 1;   ///< factor of all that the lamps emit
};

/// Matte walls, a glass ball, a ball of matte and mirror, a quad lamp and a point light; seen from
/// its front by an image of size x size.
mock::View placed_room(const RoomPlace& place, std::uint32_t size);

}  // namespace stress
