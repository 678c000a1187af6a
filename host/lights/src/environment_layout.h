// Images of all directions in other layouts than latitude and longitude.
#pragma once

#include <string>

#include "latlong_map.h"

namespace lxs {

/// `image` laid out as `mapping` ("latlong", "angular", "vcross" or "equalarea") as a
/// latitude-longitude map.
///
/// angular: Debevec's angular map ("light probe"), distance from the centre in proportion to the
/// angle from -x, +z up and +y to the left. vcross: a vertical cross of cube faces, three columns
/// by four rows, +z on top, -x in the middle, +y to its left; +x, upside down, at the foot. Both
/// lie in the light's space as LuxRender lays them. equalarea: pbrt's square, a sphere unfolded as
/// an octahedron with as many pixels for every solid angle; +z in the middle.
LatLongMap as_latlong(LatLongMap image, const std::string& mapping);

}  // namespace lxs
