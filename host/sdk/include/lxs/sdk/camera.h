// Camera and film sampling as integrators see them.
#pragma once

#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

/// Where on the film, the lens and in time one camera ray is to start.
struct CameraSample {
    Vec2 film{0.0f};  ///< in pixels of the rendered window, [0, width) x [0, height), y down
    Vec2 lens{0.0f};  ///< [0,1)^2
};

/// A camera ray and its footprint.
struct CameraRay {
    Ray ray;
    float width = 0;   ///< radius of one pixel's footprint at the ray's origin, scene units
    float spread = 0;  ///< growth of that radius per unit of distance
};

class Camera {
  public:
    virtual ~Camera() = default;
    /// A ray of weight 1; `time` is given by the integrator so that one pass shares it.
    virtual CameraRay generate(const CameraSample& sample, float time) const = 0;
    virtual float shutter_open() const = 0;
    virtual float shutter_close() const = 0;
};

/// Gives the camera samples of a render: a pure function of (seed, pass, pixel).
class Sampler {
  public:
    virtual ~Sampler() = default;
    /// Sample number `pass` of pixel (x, y); its film position lies within that pixel.
    virtual CameraSample camera_sample(std::uint64_t pass, std::uint32_t x,
                                       std::uint32_t y) const = 0;
};

}  // namespace lxs
