// Maps of one number per pixel in colours: which value has which colour, and the picture.
#include "colour_scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace bench {
namespace {

constexpr double kBrightQuantile = 0.995, kDarkQuantile = 0.05;
/// Beyond this a few bright pixels leave a linear scale's darkest colours to all others.
constexpr double kLinearRange = 10;
constexpr double kMostDecades = 4;
/// Finer steps can't be told apart, and would double the size of pictures.
constexpr double kSteps = 63;

double position(double value, const ColourScale& scale) {
    if (!(value > scale.low)) return 0;
    if (value >= scale.high) return 1;
    return scale.logarithmic ? std::log(value / scale.low) / std::log(scale.high / scale.low)
                             : (value - scale.low) / (scale.high - scale.low);
}

}  // namespace

ColourScale choose_scale(std::span<const PixelMap> maps) {
    std::vector<double> positive;
    for (const PixelMap& map : maps) {
        std::copy_if(map.values.begin(), map.values.end(), std::back_inserter(positive),
                     [](double value) { return value > 0 && std::isfinite(value); });
    }
    if (positive.empty()) return {};
    const double low = quantile(positive, kDarkQuantile);
    const double high = quantile(positive, kBrightQuantile);
    if (high <= kLinearRange * low) return {0, high, false};
    return {std::max(low, high * std::pow(10, -kMostDecades)), high, true};
}

DisplayImage colour_map(const PixelMap& map, const ColourScale& scale) {
    DisplayImage drawn{map.width_px, map.height_px, {}};
    drawn.pixels.reserve(map.values.size());
    for (const double value : map.values) {
        const double step = std::round(kSteps * position(value, scale));
        drawn.pixels.push_back(palette_colour(kMapColours, step / kSteps));
    }
    return drawn;
}

}  // namespace bench
