// The image of an emitter, as specular surfaces show it.
#pragma once

#include <array>
#include <cstdint>

#include "aips/core/sampling/eye_numbers.h"

namespace aips {

/// The ellipse of the film that an image of an emitter is taken for, and the choices at specular
/// surfaces by which it is seen there.
struct EmitterImage {
    Vec2 centre;  ///< film position, pixels
    /// Columns of a matrix that maps the unit disc, row by row, pixels.
    std::array<float, 4> axes{};
    /// Choices that show it lie in [low, high).
    SpecularChoices low{}, high{1, 1, 1, 1};
    float luminance = 0;  ///< mean of emitters within

    /// Pixels.
    double area() const;
    /// Density over film position (per pixel's area) and choices, uniform within; 0 outside.
    double pdf(Vec2 film, const SpecularChoices& choices) const;
    /// Half of the extent along x and y, pixels.
    Vec2 reach() const;
    /// Maps the unit disc and numbers in [0, 1).
    Vec2 film_at(Vec2 disc) const;
    SpecularChoices choices_at(const SpecularChoices& u) const;
    /// Share of all choices that show it, in (0, 1].
    double choice_volume() const;
};

}  // namespace aips
