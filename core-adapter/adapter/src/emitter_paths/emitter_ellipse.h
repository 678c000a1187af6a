// The ellipse that the image of an emitter is taken for, from the derivative of a chain of specular
// surfaces.
#pragma once

#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "emitter_paths/specular_chain.h"

namespace aips {

/// A point or a step on the film, pixels; or a difference of directions.
struct Plane {
    double x = 0, y = 0;

    double length() const { return std::hypot(x, y); }
};

/// The difference of two directions in a frame around one near both.
inline Plane difference(const Frame& frame, Vec3 a, Vec3 b) {
    const Vec3 d = a - b;
    return {double(dot(d, frame.s)), double(dot(d, frame.t))};
}

/// Change of a direction, in a frame, by film position.
struct Derivative {
    Plane by_x, by_y;

    double determinant() const { return by_x.x * by_y.y - by_y.x * by_x.y; }
    /// The step that changes the direction by `change`; not finite where there is none.
    Plane step_for(Plane change) const {
        const double d = determinant();
        return {(change.x * by_y.y - by_y.x * change.y) / d,
                (by_x.x * change.y - change.x * by_x.y) / d};
    }
};

/// A point of an emitter that rays can meet, as seen from `from`; false if there is none.
bool sample_emitter(const Scene& scene, LightIndex light, const SurfacePoint& from, Vec2 u,
                    DirectSample& sample);

/// Least difference of film positions that single precision tells well apart, pixels.
inline double least_difference(const EyePassInput& input) {
    return 0x1p-17 * std::max(input.width, input.height);
}

/// The image of an emitter whose point the end of a chain looks at from film position `at`; choices
/// and luminance are left open. Points of the emitter are mapped to the film by the derivative
/// there, which is that in `frame`.
EmitterImage emitter_ellipse(const EyePassInput& input, LightIndex light, const ChainVertex& end,
                             const Derivative& derivative, const Frame& frame, Plane at);

}  // namespace aips
