// What the pixel footprints of a view amount to, of which radii are multiples.
#pragma once

#include <span>

namespace aips {

/// Sum of the footprints (radii, scene units), those beyond eight medians counting as eight
/// medians. On a ground that reaches the horizon a few pixels see kilometres: they would set the
/// radius for all that is near, and another one with each seed, the plain mean having no limit
/// there. Where none is that far, as in rooms, it is the plain sum. What is not finite counts for
/// nothing. Rounded alike for any number of threads.
double bounded_footprint_sum(std::span<const float> footprints);

}  // namespace aips
