// Renders until the image's own noise no longer matters to the comparison.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "block_comparison.h"

namespace conformance {

/// Renders `passes` passes from `seed`.
using RenderPasses = std::function<render::Image(std::size_t passes, std::size_t seed)>;

/// When to stop: below `share` of the limits; below `share_within` if the image is within them, as
/// noise only adds to its distance; or before `seconds` of rendering are passed.
struct Budget {
    std::size_t first_passes = 32;  ///< of each of the two halves
    double share = 0.25;            ///< a quarter adds 3 % to a difference, noise adding in squares
    double share_within = 0.5;
    double seconds = 180;
};

struct SettledImage {
    render::Image image;
    Spread noise;            ///< of the image, see noise_of_mean
    std::size_t passes = 0;  ///< in the image
    double seconds = 0;      ///< of rendering, all rounds
    bool settled = false;    ///< false: the budget ended before the noise was low enough
};

/// Is the image within the limits of its reference?
using WithinLimits = std::function<bool(const render::Image& image)>;

/// Renders two halves of different seeds, then again with as many passes more as their difference
/// asks for, until the noise is below `budget.share` of `limit`. Each round starts anew, so that a
/// photon radius that falls with the passes has them all to fall in.
SettledImage render_settled(const RenderPasses& render, const Spread& limit,
                            const WithinLimits& within, const Budget& budget);

}  // namespace conformance
