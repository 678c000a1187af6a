// What the engine asks of a host's media that scatter light. Media are known by the host's own mark
// (Ray::medium); coefficients are per unit of distance and channel. A medium may vary in space; a
// host whose media are the same everywhere leaves the members that name a place as they are.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "aips/adapter/scene.h"

namespace aips {

/// How far light goes in a medium before something happens to it.
struct Flight {
    float distance = 0;     ///< to the collision, or the segment's whole length
    bool collides = false;  ///< within the segment
    Rgb weight = kWhite;    ///< transmittance over `distance` / (density of the collision, or the
                            ///< probability of none); for collisions without scattering()
};

/// A direction drawn from a phase function.
struct PhaseSample {
    Vec3 direction;  ///< unit, in which the light goes on
    Rgb weight;      ///< phase / density
};

/// Share of light that goes `distance` without a collision (Beer-Lambert).
inline Rgb transmittance(Rgb extinction, float distance) {
    return {std::exp(-extinction.r * distance), std::exp(-extinction.g * distance),
            std::exp(-extinction.b * distance)};
}

/// All const members may be called from many threads.
class Media {
  public:
    virtual ~Media() = default;
    /// Whether a medium scatters; the other members are called for such media only.
    virtual bool scatters(const void* medium) const = 0;
    /// Marks may tell more of a ray than the medium that it travels in, such as what lies around
    /// that: the one mark by which rays in the same medium are known as such.
    virtual const void* alone(const void* medium) const { return medium; }
    /// Of light by collisions: absorption and scattering together. Of a medium that varies, the
    /// mean, which decides on what is drawn alone.
    virtual Rgb extinction(const void* medium) const = 0;
    virtual Rgb scattering(const void* medium) const = 0;
    /// scattering() at a place.
    virtual Rgb scattering_at(const void* medium, Vec3 /*position*/) const {
        return scattering(medium);
    }
    /// Draws the distance to a collision on the first `segment` of a ray from u in [0,1)^2.
    /// `carried` is what the path carries by channel: the density should follow it, so that weights
    /// stay bounded.
    virtual Flight sample_flight(const void* medium, const Ray& ray, float segment, Rgb carried,
                                 Vec2 u) const = 0;
    /// Share of light that goes each of these distances along a ray without a collision
    /// (Beer-Lambert); of a medium that varies, estimates that are right in the mean, drawn from u.
    virtual void transmittances(const void* medium, const Ray& /*ray*/,
                                std::span<const float> distances, float /*u*/,
                                std::span<Rgb> shares) const {
        const Rgb rate = extinction(medium);
        for (std::size_t i = 0; i < distances.size(); ++i)
            shares[i] = transmittance(rate, distances[i]);
    }
    /// Phase function per steradian for light turned by an angle of this cosine; integrates to 1.
    virtual Rgb phase(const void* medium, float cosine) const = 0;
    /// phase() of each cosine. Overridden where many at once cost less.
    virtual void phases(const void* medium, std::span<const float> cosines,
                        std::span<Rgb> values) const {
        std::ranges::transform(cosines, values.begin(),
                               [&](float cosine) { return phase(medium, cosine); });
    }
    /// Draws the way that light which came along `direction` takes.
    virtual PhaseSample sample_phase(const void* medium, Vec3 direction, Rgb carried,
                                     Vec2 u) const = 0;
    /// Scene::visibility() for a point within a medium.
    virtual Rgb visibility(const void* medium, Vec3 from, const DirectSample& light,
                           float time) const = 0;
};

}  // namespace aips
