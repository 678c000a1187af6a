// Light sources as integrators see them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lxs/sdk/types.h"

namespace lxs {

/// Coordinates from which a light emits a photon, in [0, 1)^4: finer than single precision tells
/// apart, and rounding to it may give 1.
using PrimaryPoint = std::array<double, 4>;

/// A photon leaving a light (Light::sample_emission).
struct EmissionSample {
    Ray ray;            ///< origin already offset robustly off the emitting surface
    Rgb power{0.0f};    ///< Le * |cos| / (density of position and direction), watts
    Vec3 normal{0.0f};  ///< emitting surface's geometric normal; zero for point-like lights
};

/// A direction from a surface point to a light (Light::sample_direct).
struct DirectSample {
    Vec3 wi{0.0f};           ///< unit, towards the light
    float distance = 0;      ///< to the sampled light point; infinity for lights at infinity
    Vec3 segment_end{0.0f};  ///< where a segment to the light point ends: off the light's surface
                             ///< by the bounds of rounding; unused for lights at infinity
    Rgb radiance{0.0f};      ///< arriving along wi if unoccluded; for delta lights the
                             ///< irradiance on a surface facing wi
    float pdf = 0;           ///< per steradian; 1 for delta lights; 0 means nothing was sampled
    bool delta = false;      ///< point, spot, distant: cannot be met by a scattered ray
    std::uint32_t primitive = 0;  ///< of the light's shape, that the light point lies on
};

/// A light source. Emissive geometry has one Light per shape.
class Light {
  public:
    virtual ~Light() = default;

    /// Plugin name, e.g. "area", "point".
    virtual std::string_view kind() const = 0;
    /// Index into Scene::light_groups().
    virtual std::uint32_t group() const = 0;
    /// Estimate of the emitted power in watts, luminance-weighted; >= 0; 0 only for a dead light.
    /// For the probability of choosing lights; need not be exact.
    virtual float power() const = 0;
    /// True for infinite, sky and sun lights: rays that leave the scene see `escaped`.
    virtual bool at_infinity() const { return false; }
    /// True where the camera does not see it, neither straight nor through what passes light
    /// straight on.
    virtual bool hidden_from_camera() const { return false; }
    /// True where no ray ever meets it (point, spot, parallel beam): DirectSample::delta always is.
    virtual bool is_delta() const { return false; }

    /// Draws a photon from primary coordinates: u[0..1] position, u[2..3] direction. False if these
    /// emit nothing. Positions on what may be far wider than a view (the disc beside the scene) are
    /// worked out in double precision.
    virtual bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const = 0;
    /// Draws a direction to the light from the surface point p (normal n, for choosing only).
    virtual bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                               DirectSample& sample) const = 0;
    /// Density per steradian with which sample_direct, called at (p, n), draws direction wi, given
    /// that the ray meets this light at `light_p` with geometric normal `light_n` on primitive
    /// `primitive` (both unused for lights at infinity). 0 for delta lights.
    virtual float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                             const Vec3& light_n, std::uint32_t primitive) const = 0;
    /// Primary coordinates from which sample_emission sends a photon through the point `p`, up to
    /// rounding, from the light point that `sample` (as by sample_direct from `p`: wi, and for
    /// finite lights segment_end and primitive) names; in [0,1). Coordinates that the photon does
    /// not depend on are left as the caller set them. False where there are none or the light
    /// can't tell; `u` is then undefined. Only steers sampling: never part of a value.
    virtual bool emission_coordinates(const Vec3& /*p*/, const DirectSample& /*sample*/,
                                      PrimaryPoint& /*u*/) const {
        return false;
    }
    /// Radiance seen along a direction that leaves the scene (lights at infinity only).
    virtual Rgb escaped(const Vec3& /*direction*/) const { return Rgb(0.0f); }
};

}  // namespace lxs
