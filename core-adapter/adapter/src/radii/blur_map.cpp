// Blur by pixel, and what it asks for.
#include "radii/blur_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radii/constants.h"

namespace aips {

BlurMap::BlurMap(std::size_t pixels) : pixels_(pixels) {}

void BlurMap::Pixel::add(double of_point, double variance_of_point) {
    constexpr double kKept = 1 - kBlurForgotten;
    difference = kKept * difference + of_point;
    squares = kKept * kKept * squares + of_point * of_point;
    variance = kKept * kKept * variance + variance_of_point;
    weights = float(kKept * double(weights) + 1);
    squared_weights = float(kKept * kKept * double(squared_weights) + 1);
    if (points < std::numeric_limits<std::uint32_t>::max()) ++points;
}

/// Variance of the sum of differences: what single photons tell, or a share of what points tell by
/// themselves, if that is more. Photons of one path come together, those of chains for long.
double BlurMap::Pixel::noise() const {
    if (points < kBlurComparedFrom) return variance;
    const double weight = double(weights);
    const double of_mean = double(squared_weights) / (weight * weight);
    const double apart = (squares - of_mean * difference * difference) / (1 - of_mean);
    return std::max(variance, kBlurApart * apart);
}

void BlurMap::add(std::uint32_t pixel, const DiscDensities& densities) {
    const double difference = densities.whole - densities.half;
    if (!std::isfinite(difference * difference) || !std::isfinite(densities.variance)) return;
    Pixel& p = pixels_[pixel];
    p.add(difference, densities.variance);
    const double noise = p.noise(), square = p.difference * p.difference;
    const double bias = 2 / double(p.weights);
    const double squared_bias = bias * bias * (square - noise);
    // Of the image so far, in which each point counts once.
    const double of_image = noise / (double(p.squared_weights) * double(p.points));
    if (square > kSureOfBlur * noise && squared_bias > kBlurTooLarge * of_image) {
        p.narrowing = std::max(float(kLeastNarrowing), p.narrowing * float(kNarrowingStep));
    } else if (squared_bias < kBlurSmall * of_image) {
        p.narrowing = std::min(1.0f, p.narrowing * float(kWideningStep));
    }
}

void BlurMap::state(StateArchive& archive) {
    for (Pixel& p : pixels_) {
        archive.value(p.difference);
        archive.value(p.squares);
        archive.value(p.variance);
        archive.value(p.weights);
        archive.value(p.squared_weights);
        archive.value(p.points);
        archive.value(p.narrowing);
        StateArchive::check(p.narrowing >= float(kLeastNarrowing) && p.narrowing <= 1,
                            "a search disc narrowed by what none can be");
    }
}

}  // namespace aips
