// Camera and film sampling as integrators see them.
#pragma once

#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

/// Where on the film, the lens and in time one camera ray is to start.
struct CameraSample {
    Vec2 film{0.0f};  ///< in pixels of the rendered window, [0, width) x [0, height), y down
    Vec2 lens{0.0f};  ///< [0,1)^2; its middle for cameras without a lens
};

/// A camera ray and its footprint.
struct CameraRay {
    Ray ray;
    float width = 0;   ///< radius of one pixel's footprint at the ray's origin, scene units
    float spread = 0;  ///< growth of that radius per unit of distance
    float depth = 0;   ///< of the origin, scene units: what a depth layer shows
    float depth_per_distance = 1;  ///< its growth along the ray

    /// Depth of the ray's point at `distance` from its origin: along the camera's axis; for
    /// cameras that look all around, along the ray.
    float depth_at(float distance) const { return depth + depth_per_distance * distance; }
};

class Camera {
  public:
    virtual ~Camera() = default;
    /// A ray of weight 1; `time` is given by the integrator so that one pass shares it.
    virtual CameraRay generate(const CameraSample& sample, float time) const = 0;
    virtual float shutter_open() const = 0;
    virtual float shutter_close() const = 0;
};

/// What `Sampler "metropolis"` asks of an integrator that runs Markov chains: Kelemen et al. 2002,
/// "A simple and robust mutation strategy for the Metropolis light transport algorithm".
struct MetropolisSettings {
    double large_probability = 0.4;  ///< of drawing all of a sample anew, in [0, 1]
    /// Rejections in a row after which the next sample that carries light is accepted whatever its
    /// brightness, which biases slightly; 0: never.
    std::uint32_t max_consecutive_rejects = 0;
    double film_range = 0;  ///< farthest that a small mutation moves a sample on the film, pixels
};

/// Gives the camera samples of a render: a pure function of (seed, pass, pixel).
class Sampler {
  public:
    virtual ~Sampler() = default;
    /// Not null if the scene wants samples from Markov chains, which choose their own places on
    /// the film. Only integrators whose plugin declares `runs_metropolis` are told so.
    virtual const MetropolisSettings* metropolis() const { return nullptr; }
    /// Sample number `pass` of pixel (x, y); its film position lies within that pixel.
    virtual CameraSample camera_sample(std::uint64_t pass, std::uint32_t x,
                                       std::uint32_t y) const = 0;
};

}  // namespace lxs
