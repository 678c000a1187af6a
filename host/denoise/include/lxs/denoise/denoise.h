// A denoiser without training: a pixel is averaged with those around that its own noise can't tell
// from it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// What one half of a render's passes says of the image, [pixel], row by row. Means may be below
/// zero, where a filter's negative lobes have drawn them: they are what is unbiased.
struct HalfImage {
    std::vector<Rgb> mean;      ///< radiance
    std::vector<Rgb> variance;  ///< of that mean
    double passes = 0;          ///< > 0
};

/// One number of each pixel that tells surfaces apart; of any unit.
struct GuideChannel {
    std::vector<float> value;
    std::vector<float> variance;  ///< of the value, e.g. from both halves
    /// Differences whose square is well below this join pixels, however sure they are.
    float least = 0;
};

struct NoisyImage {
    std::uint32_t width = 0, height = 0;
    std::array<HalfImage, 2> halves;   ///< of different passes: their noise is independent
    std::vector<GuideChannel> guides;  ///< none: colours alone tell pixels apart
};

/// The image without most of its noise, on the scale of the halves' means, below zero where they
/// are. Each half is averaged with weights that the other half gives, so that weights know nothing
/// of the noise that they weigh. Two pixels count as alike where their surroundings differ by no
/// more than their variances explain (Buades et al. 2005; with variances Rousselle et al. 2012,
/// "Adaptive Rendering with Non-Local Means Filtering"; a soft form of the tests of Sakai et al.
/// 2024, "A Statistical Approach to Monte Carlo Denoising"), and their guides likewise. What only
/// one half has seen, and far above the other half's noise, is cut to that noise first.
///
/// As variances fall, fewer pixels pass for alike and less is cut: the result tends to what the
/// halves' means tend to. Values that are not finite count as zero. The same bits for any number of
/// threads; takes some 15 us of processor time a pixel, 250 bytes a pixel while it runs.
std::vector<Rgb> denoise(const NoisyImage& image);

}  // namespace lxs
