// LuxRender's headers, which only the C++17 half of the shim includes.
#pragma once

#include "lux.h"

#include "camera.h"
#include "film.h"
#include "light.h"
#include "material.h"
#include "reflection/bxdf.h"
#include "sampling.h"
#include "scene.h"
#include "volume.h"

#include "lux_view.h"

namespace aips::luxrender {

inline luxrays::Point point_of(const Triple& t) {
    return {t.v[0], t.v[1], t.v[2]};
}
inline luxrays::Vector vector_of(const Triple& t) {
    return {t.v[0], t.v[1], t.v[2]};
}
/// Of a point, vector or normal.
template <class T>
Triple triple_of(const T& v) {
    return {{v.x, v.y, v.z}};
}
/// LuxRender's fourth wavelength repeats the second and does not count.
inline Triple triple_of(const luxrays::SWCSpectrum& s) {
    return {{s.c[0], s.c[1], s.c[2]}};
}

}  // namespace aips::luxrender
