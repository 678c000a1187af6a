// Images as a page shows them: tone-mapped or as a signed error in colours, in PNG data URIs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "error_metrics.h"

namespace bench {

/// How radiance becomes 8-bit values: (exposure x radiance)^(1 / gamma), clamped to 0..1.
struct ToneMap {
    double exposure = 1;
    double gamma = 2.2;
};

/// Rectangle of pixels, from the top left.
struct Crop {
    int x = 0, y = 0, width_px = 0, height_px = 0;
};

using Rgb8 = std::array<std::uint8_t, 3>;

/// Blue (too dark) over white (0) to red (too bright), equally spaced; safe for red-green
/// blindness. RdBu of ColorBrewer (Brewer 2003).
inline constexpr std::array<Rgb8, 9> kErrorColours{{{5, 48, 97},
                                                    {33, 102, 172},
                                                    {67, 147, 195},
                                                    {146, 197, 222},
                                                    {255, 255, 255},
                                                    {244, 165, 130},
                                                    {214, 96, 77},
                                                    {178, 24, 43},
                                                    {103, 0, 31}}};

/// Between the palette's colours (two or more), from the first at 0 to the last at 1; `position` is
/// a number, and clamped.
Rgb8 palette_colour(std::span<const Rgb8> palette, double position);

/// As "#rrggbb".
std::vector<std::string> colour_names(std::span<const Rgb8> palette);

/// Between those colours; `value` is clamped to -1..1, and is 0 if it isn't a number.
Rgb8 error_colour(double value);

/// Exposure that puts the 95th percentile of the luminance of the pixels that aren't black to 0.8;
/// 1 if all are black.
double automatic_exposure(const Image& image);

/// 8-bit pixels, row by row.
struct DisplayImage {
    int width_px = 0, height_px = 0;
    std::vector<Rgb8> pixels;
};

DisplayImage tone_map(const Image& image, const ToneMap& map, const Crop& crop);

/// Colours of relative_difference / scale.
DisplayImage error_map(std::span<const float> differences, double scale, const Crop& crop);

/// (I-R) / (R + sqrt(epsilon)) of the luminances, R being the mean of the references and epsilon
/// relative_epsilon; row by row in the crop.
std::vector<float> relative_difference(const Image& image, const Image& first, const Image& second,
                                       const Crop& crop);

/// "data:image/png;base64,...".
std::string png_data_uri(const DisplayImage& image);

}  // namespace bench
