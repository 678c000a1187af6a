// The image of emission by direction that a light's statement names: mapname, iesname, flipz.
#pragma once

#include "latlong_map.h"
#include "lxs/lights/lights.h"

namespace lxs {

/// True if the statement names an image or a photometric file.
bool names_profile(const ParameterReader& reader);

/// What "gamma" and "colorspace" say of an image.
StoredCurve map_curve(const ParameterReader& reader);
/// The image at mapname, linear by map_curve(); its colours are those of a filter before white
/// light, unless plainvalues takes them as they are.
LatLongMap read_map(const ParameterReader& reader, const AssetResolver& resolve);

/// Emission over all directions, +z in the top row: the image at mapname, the intensities at
/// iesname relative to their largest, vertical angle 0 along +z, or the product of both; upside
/// down with flipz. Throws InputError for files that can't be read.
LatLongMap sphere_map(const ParameterReader& reader, const AssetResolver& resolve);

}  // namespace lxs
