// The film as integrators see it: where samples of the image go.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lxs/sdk/types.h"

namespace lxs {

/// The camera samples of one pass and what they saw.
struct PassSamples {
    std::span<const Vec2> positions;  ///< film positions in pixels, in any order
    /// Radiance of sample i in light group g at [i * groups + g]; finite and not negative.
    std::span<const Rgb> radiance;
    std::uint32_t groups = 1;
    /// Weight of the pass in the mean over passes, > 0 (photon mappers: photon paths shot).
    double weight = 1;
};

class Film {
  public:
    virtual ~Film() = default;
    virtual std::uint32_t width() const = 0;   ///< of the rendered window, pixels
    virtual std::uint32_t height() const = 0;  ///< of the rendered window, pixels
    virtual std::uint32_t light_groups() const = 0;

    /// Adds one pass through the pixel filter. The sum's order depends on the samples' order alone,
    /// so that an image has the same bits for any number of threads. Samples that are not finite or
    /// negative are refused and counted.
    virtual void add_pass(const PassSamples& samples) = 0;
    /// Forgets all passes so far (after learning passes that must not stay in the image).
    virtual void clear() = 0;
    /// Replaces the extra float layer `name` (debug views): width * height values, row by row.
    virtual void set_layer(std::string_view name, std::span<const float> values) = 0;
};

}  // namespace lxs
