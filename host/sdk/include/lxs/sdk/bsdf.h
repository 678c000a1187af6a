// How a surface scatters light at one point: the interface between materials and integrators.
#pragma once

#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

/// What is carried along the path. Radiance (eye paths) is scaled by the squared index ratio at a
/// refraction, importance-like photon power is not (Veach 1997, section 5.2). The shading-normal
/// factor is the integrator's business, not the Bsdf's.
enum class Transport : std::uint8_t { Radiance, Power };

/// Kinds of lobes, to be combined as bits.
using LobeMask = std::uint8_t;
inline constexpr LobeMask kDiffuse = 1;
inline constexpr LobeMask kGlossy = 2;
inline constexpr LobeMask kSpecular = 4;  ///< a Dirac delta; `evaluate` and `pdf` never see it
inline constexpr LobeMask kAllLobes = 7;

/// Result of Bsdf::sample.
struct BsdfSample {
    Vec3 wi{0.0f};             ///< sampled direction, unit, pointing away from the surface
    Rgb weight{0.0f};          ///< f * |cos(wi, ns)| / pdf; for specular lobes the whole quotient
    float pdf = 0;             ///< per steradian, over the lobes asked for; 0 for a specular lobe
    LobeMask lobe = 0;         ///< the one kind that was sampled
    bool transmitted = false;  ///< wi and wo lie on different sides of the geometric surface
    bool straight = false;     ///< passes through undeviated: null or architectural glass
    /// Index of the one component that is left of `weight` where light is dispersed, else
    /// kAllComponents: the ray that leaves carries on as the one that came.
    std::int8_t component = kAllComponents;
};

/// Scattering function at a surface point. Directions are unit, in world space, pointing away
/// from the point: `wo` to where the path comes from, `wi` to where it goes. Cosines are taken to
/// the shading normal; the side (reflection or transmission) is decided by the geometric normal.
///
/// Lives in the memory handed to Material::scatter and is never destroyed: implementations must be
/// trivially destructible.
class Bsdf {
  public:
    /// The lobes that exist here.
    virtual LobeMask lobes() const = 0;
    /// f(wo, wi) per steradian, without cosine, over the non-specular lobes in `mask`.
    virtual Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                         LobeMask mask) const = 0;
    /// Density per steradian with which `sample(mask)` draws `wi` through non-specular lobes,
    /// including the probability of choosing them among all lobes in `mask`.
    virtual float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const = 0;
    /// Draws a direction from the lobes in `mask` with u in [0,1)^2 and the choice of lobe from
    /// `u_lobe`. False when nothing is scattered (absorbed); `sample.weight` is then not set.
    virtual bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                        LobeMask mask, BsdfSample& sample) const = 0;
    /// Where `sample` has two specular lobes to choose from, and no other, the probability that it
    /// takes the first of them: it does where u_lobe is below, else it takes the second. 0: there
    /// is no such choice. Lets integrators go both ways.
    virtual float first_specular(const Vec3& /*wo*/) const { return 0; }
    /// Approximate albedo per channel of the lobes in `mask` seen from `wo`, in [0, 1]; used for
    /// choosing between strategies only, never as a value of the image.
    virtual Rgb albedo(const Vec3& wo, LobeMask mask) const = 0;
    /// If the Bsdf is exactly Lambertian reflection on both shading sides (f = Kd / pi, no other
    /// lobe), true and Kd is written; lets integrators keep it compactly.
    virtual bool lambertian(Rgb& /*kd*/) const { return false; }

  protected:
    ~Bsdf() = default;
};

}  // namespace lxs
