// Maps of one number per pixel in colours: which value has which colour, and the picture.
#pragma once

#include <array>
#include <span>

#include "display_image.h"
#include "pixel_map.h"

namespace bench {

/// Values from `low` (first colour) to `high` (last colour); what is beyond has the colour of that
/// end.
struct ColourScale {
    double low = 0, high = 1;
    bool logarithmic = false;  ///< then 0 < low < high
};

/// Dark blue over green to yellow, equally spaced; lightness rises evenly, so that it reads in grey
/// and with any colour vision. Viridis (van der Walt and Smith 2015).
inline constexpr std::array<Rgb8, 9> kMapColours{{{68, 1, 84},
                                                  {71, 44, 122},
                                                  {59, 81, 139},
                                                  {44, 113, 142},
                                                  {33, 144, 141},
                                                  {39, 173, 129},
                                                  {92, 200, 99},
                                                  {170, 220, 50},
                                                  {253, 231, 37}}};

/// One scale for all maps, of their positive values: up to what one in two hundred exceeds. From 0,
/// or, if the value that one in twenty is below is less than a tenth of that, logarithmic from
/// there (but no more than four decades). 0 to 1 if no value is positive.
ColourScale choose_scale(std::span<const PixelMap> maps);

/// In 64 steps of colour. Values that aren't numbers have the first colour.
DisplayImage colour_map(const PixelMap& map, const ColourScale& scale);

}  // namespace bench
