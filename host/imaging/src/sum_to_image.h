// Layers that are parts of the image.
#pragma once

#include <span>

#include "lxs/imaging/file_layers.h"

namespace lxs {

/// Makes `parts` sum to `image`, pixel by pixel and up to rounding. Their means do so by
/// themselves; but what a filter's negative lobes or colours beyond the film's draw below zero is
/// settled in each by itself (FilmAccumulator::resolve_total, ColorConversion), and the image keeps
/// its bits. Each part takes its share of what is missing or too much, and keeps its mean over the
/// image as nearly as can be (iterative proportional fitting, Deming & Stephan 1940).
void sum_to_image(std::span<ColorLayer> parts, std::span<const Rgb> image);

}  // namespace lxs
