// Blur by pixel, and what it asks for.
#include "radii/blur_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "aips/core/base/constants.h"
#include "base/parallel_for.h"
#include "radii/constants.h"

namespace aips {

BlurMap::BlurMap(std::size_t pixels) : pixels_(pixels) {}

/// Sums of the weights of n passes, and of their squares.
struct BlurMap::Weights {
    double sum, of_squares;

    explicit Weights(std::uint32_t passes) {
        constexpr double kKept = 1 - kBlurForgotten;
        const double left = std::pow(kKept, double(passes));
        sum = (1 - left) / (1 - kKept);
        of_squares = (1 - left * left) / (1 - kKept * kKept);
    }
};

/// A pixel's points of one pass see the same photons where their discs overlap: one that is as
/// noisy as the mean of them stands for all.
void BlurMap::Pixel::end_pass() {
    constexpr double kKept = 1 - kBlurForgotten;
    const double now = double(of_pass) / points, noise_now = double(variance_of_pass) / points;
    of_pass = variance_of_pass = 0;
    points = 0;
    if (!std::isfinite(now * now) || !std::isfinite(noise_now)) return;
    difference = kKept * difference + now;
    squares = kKept * kKept * squares + now * now;
    variance = kKept * kKept * variance + noise_now;
    if (passes < std::numeric_limits<std::uint32_t>::max()) ++passes;
    judge(now);
}

/// Variance of the sum of differences: what single photons tell, or a share of what passes tell by
/// themselves, if that is more. Photons of one path come together, those of chains for long.
double BlurMap::Pixel::noise(const Weights& weights) const {
    if (passes < kBlurComparedFrom) return variance;
    const double of_mean = weights.of_squares / (weights.sum * weights.sum);
    const double apart = (squares - of_mean * difference * difference) / (1 - of_mean);
    return std::max(variance, kBlurApart * apart);
}

/// A disc that has narrowed clear of what blurred wider ones must not narrow on by what they saw:
/// the pass itself has to show much of it.
void BlurMap::Pixel::judge(double now) {
    const Weights weights(passes);
    const double of_noise = noise(weights), square = difference * difference;
    const double bias = 2 / weights.sum;
    const double squared_bias = bias * bias * (square - of_noise);
    // Of the image so far, in which each pass counts once.
    const double of_image = of_noise / (weights.of_squares * double(passes));
    if (square > kSureErrors * kSureErrors * of_noise && squared_bias > kBlurTooLarge * of_image) {
        if (now * difference * weights.sum < kBlurStillSeen * square) return;
        narrowing = std::max(float(kLeastNarrowing), narrowing * float(kNarrowingStep));
    } else if (squared_bias < kBlurSmall * of_image) {
        narrowing = std::min(1.0f, narrowing * float(kWideningStep));
    }
}

void BlurMap::add(std::uint32_t pixel, const DiscDensities& densities) {
    Pixel& p = pixels_[pixel];
    p.of_pass += float(densities.whole - densities.half);
    p.variance_of_pass += float(densities.variance);
    ++p.points;
}

void BlurMap::end_pass() {
    in_chunks(pixels_.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (Pixel& p : std::span(pixels_).subspan(first, last - first)) {
            if (p.points > 0) p.end_pass();
        }
    });
}

void BlurMap::state(StateArchive& archive) {
    for (Pixel& p : pixels_) {
        archive.value(p.difference);
        archive.value(p.squares);
        archive.value(p.variance);
        archive.value(p.passes);
        archive.value(p.narrowing);
        StateArchive::check(p.narrowing >= float(kLeastNarrowing) && p.narrowing <= 1,
                            "a gather disc narrowed by what none can be");
    }
}

}  // namespace aips
