// In which media a place lies, where no statement says so: straight lines from there meet the
// surfaces that bound them.
#pragma once

#include <functional>
#include <span>

#include "lxs/sdk/scene.h"
#include "surface.h"

namespace lxs {

/// The nearest surface along a ray, with place, normals and media of `hit`; null if there is none.
using MeetSurface = std::function<const Surface*(const Ray& ray, SurfaceHit& hit)>;

/// The media around `places`, which are those of one thing, the camera or a light, within
/// `outside`, the media of what no surface bounds. Open and faulty surfaces make lines disagree: a
/// quarter of those that tell anything decides, or those that say what is `declared` of the thing,
/// if that is not kNoMedium and there are such.
EnteredMedia media_around(const MeetSurface& meet, std::span<const Vec3> places,
                          const EnteredMedia& outside, MediumNumber declared);

/// The innermost medium at a place as one line from there tells it, along `direction`, unit;
/// `outside` if that meets no surface that bounds one.
MediumNumber medium_along(const MeetSurface& meet, const Vec3& place, const Vec3& direction,
                          MediumNumber outside);

}  // namespace lxs
