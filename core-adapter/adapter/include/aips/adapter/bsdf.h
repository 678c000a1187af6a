// How a surface scatters: what the engine asks of a host's materials.
#pragma once

#include <cstdint>

#include "aips/core/base/rgb.h"
#include "aips/core/base/vector.h"

namespace aips {

/// What travels along a path. Radiance (eye side) takes the squared index ratio at a refraction,
/// photon power does not (Veach 1997, section 5.2).
enum class Transport : std::uint8_t { Radiance, Power };

/// Kinds of lobes, combined as bits.
using LobeMask = std::uint8_t;
inline constexpr LobeMask kDiffuse = 1;
inline constexpr LobeMask kGlossy = 2;
inline constexpr LobeMask kSpecular = 4;  ///< a Dirac delta, never guided, never stored
inline constexpr LobeMask kNonSpecular = kDiffuse | kGlossy;
inline constexpr LobeMask kAllLobes = 7;

/// Mark of a path that has not been dispersed.
inline constexpr std::int8_t kAllComponents = -1;

/// A direction drawn by Bsdf::sample.
struct BsdfSample {
    Vec3 wi;                ///< unit, away from the surface
    Rgb weight;             ///< f * |cos(wi, ns)| / pdf; the whole quotient for specular lobes
    float pdf = 0;          ///< per steradian over the lobes asked for; 0 for specular lobes
    LobeMask lobe = 0;      ///< the kind that was sampled
    bool straight = false;  ///< passed undeviated (null, architectural glass)
    /// Index of the one component that is left of `weight` where light is dispersed, else
    /// kAllComponents: the path carries on with what it had.
    std::int8_t component = kAllComponents;
};

/// Scattering function at one point. Directions are unit, in world space, away from the surface;
/// cosines go to the shading normal, sides are told by the geometric one. Shading-normal factors
/// are the engine's business. Lives in memory that is dropped without destruction, so
/// implementations must be trivially destructible.
class Bsdf {
  public:
    virtual LobeMask lobes() const = 0;
    /// f(wo, wi), per steradian, without cosine, of the non-specular lobes in `mask`.
    virtual Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const = 0;
    /// Density per steradian of `sample` with the same mask, non-specular lobes only.
    virtual float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const = 0;
    /// Draws a direction; false when the light is absorbed.
    virtual bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                        BsdfSample& sample) const = 0;
    /// Where `sample` has two specular lobes to choose from, and no other, the probability that it
    /// takes the first of them: it does where u_lobe is below, else it takes the second. 0: there
    /// is no such choice. With it emitters are looked for both ways.
    virtual float first_specular(Vec3 /*wo*/) const { return 0; }
    /// Approximate albedo in [0, 1], for choices only, never as a value of the image.
    virtual Rgb albedo(Vec3 wo, LobeMask mask) const = 0;
    /// True and Kd if this is exactly f = Kd / pi on both sides, so that it can be kept compactly.
    virtual bool lambertian(Rgb& /*kd*/) const { return false; }

  protected:
    ~Bsdf() = default;
};

}  // namespace aips
