// The film as integrators see it: where samples of the image go.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lxs/sdk/layers.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// The camera samples of one pass and what they saw.
struct PassSamples {
    std::span<const Vec2> positions;  ///< film positions in pixels, in any order
    /// Radiance of sample i in light group g at [i * groups + g]; finite and not negative.
    std::span<const Rgb> radiance;
    std::uint32_t groups = 1;
    double weight = 1;  ///< of the pass in the mean over passes, > 0
    /// A second part of what the samples saw, laid out as `radiance`, or nothing. It has a mean of
    /// its own, over the passes that have it, and the image is the sum of both: passes may count in
    /// full for what their eye paths saw, and for little in what their photons brought.
    std::span<const Rgb> second_radiance = {};
    double second_weight = 1;  ///< of the pass in the second mean, > 0
};

/// Samples whose density over the film says how bright it is: they may lie anywhere, each with a
/// radiance already divided by its density, as the samples of Markov chains and of light paths do.
struct PassSplats {
    std::span<const Vec2> positions;  ///< film positions in pixels, in any order
    /// Contribution of splat i in light group g at [i * groups + g], over its density with respect
    /// to a uniform distribution over the film; finite and not negative.
    std::span<const Rgb> radiance;
    std::uint32_t groups = 1;
    /// Samples drawn, > 0, those left out because they are black among them.
    double samples = 1;
};

class Film {
  public:
    virtual ~Film() = default;
    virtual std::uint32_t width() const = 0;   ///< of the rendered window, pixels
    virtual std::uint32_t height() const = 0;  ///< of the rendered window, pixels
    virtual std::uint32_t light_groups() const = 0;
    /// Layers that it takes beside what an integrator adds of its own accord; never change.
    virtual LayersWanted layers_wanted() const { return {}; }

    /// Adds one pass through the pixel filter. The sum's order depends on the samples' order alone,
    /// so that an image has the same bits for any number of threads. Samples that are not finite or
    /// negative are refused and counted.
    virtual void add_pass(const PassSamples& samples) = 0;
    /// Adds samples without dividing by how many fell near a pixel: over all calls, a pixel gains
    /// pixels / sum(samples) * sum(f * radiance) / F with f the filter and F its integral over the
    /// part of the film that it covers. In the mean a uniform density of splats thus gives a
    /// constant image up to the borders, and the image's sum is that of the splats. What add_pass
    /// gives is kept apart and summed with it. Order and invalid samples as with add_pass.
    virtual void add_splats(const PassSplats& splats) = 0;
    /// Adds one pass of the extra colour layer `name`, through the same filter and into the same
    /// kind of mean as the image; `samples` has one group.
    virtual void add_layer_pass(std::string_view name, const PassSamples& samples) = 0;
    /// Adds the parts of the image that a pass brought, the image being their sum up to rounding;
    /// only if the film wants layers of parts. As add_pass and add_splats, with an ImagePart where
    /// those have a light group.
    virtual void add_parts(const PassSamples& /*parts*/) {}
    virtual void add_splats_of_parts(const PassSplats& /*parts*/) {}
    /// Adds what the samples of one pass saw of surfaces, one entry a position; only if the film
    /// wants layers of surfaces. What is not finite is refused and counted.
    virtual void add_surfaces(std::span<const Vec2> /*positions*/,
                              std::span<const SeenSurface> /*surfaces*/) {}
    /// Adds what blurs light in one pass, of an integrator that gathers photons; only if the film
    /// wants the layer of bias. `radiance` is what the inner half of each gather disc's area
    /// brought the samples, `second_radiance` what the whole disc did, in one group and with one
    /// weight.
    virtual void add_bias(const PassSamples& /*samples*/) {}
    /// Forgets all passes so far (after learning passes that must not stay in the image), those of
    /// extra colour layers too.
    virtual void clear() = 0;
    /// Replaces the extra float layer `name` (debug views): width * height values, row by row.
    virtual void set_layer(std::string_view name, std::span<const float> values) = 0;
};

}  // namespace lxs
