// How much an error weighs in each pixel: 1 / (L^2 + eps^2), L being the pixel's luminance so far.
//
// A guide that minimises the relative squared error divides by L^2. The running estimate is
// blurred, as single pixels are noisy for long; it only steers sampling, so that any error in it
// costs variance and not truth. Sums are in double precision: of n eye paths in a pixel they are
// off by n 2^-53 at most.
#pragma once

#include <span>
#include <vector>

#include "aips/core/base/learned_parts.h"
#include "base/constants.h"
#include "contribution/constants.h"
#include "contribution/pixel_luminance.h"
#include "estimate/photon_occlusion.h"
#include "eye/eye_pass.h"

namespace aips {

class PixelImportance {
  public:
    PixelImportance(std::uint32_t width, std::uint32_t height);

    /// Adds a pass: what its eye paths saw.
    void add_pass(std::span<const PixelLuminance> seen);

    /// [visible point]: weight of a squared error of luminance there, over the mean of all, so that
    /// scores of all passes have one scale, whatever the scene's units and however dark the image
    /// was when they were given. Before the first pass all are kUnknownWeight. Returns the mean, by
    /// which they were divided.
    double weigh(const EyeImage& image, std::vector<float>& weights) const;

    /// The weights of weigh() are then for what reaches visible points: `occlusion` outlives this.
    void set_occlusion(const PhotonOcclusion& occlusion) { occlusion_ = &occlusion; }

    /// Weight of a squared error of luminance in the pixel of this number (film_pixel.h), eps being
    /// this share of the mean luminance; 1 before the first pass.
    float weight(std::size_t pixel, double darkest_share = kDarkestShare) const;

    /// The same where it is decided who carries light: dark pixels weigh more.
    float weight_of_sharing(std::size_t pixel) const {
        return weight(pixel, kDarkestShareOfSharing);
    }

    /// Saves what was added, or restores it into a new estimate for the same film.
    void state(StateArchive& archive);

    /// Saves the estimate for another render of as large a film, or takes it before the first pass,
    /// as that of few passes.
    void learned(LearnedParts& parts);

    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    void fade();
    void estimate();
    void blur();

    std::uint32_t width_, height_;
    std::vector<double> sum_, count_;      // [pixel]: of luminance, of eye paths
    std::vector<float> blurred_;           // [pixel]: mean luminance
    std::vector<double> column_, window_;  // [pixel]: scratch
    const PhotonOcclusion* occlusion_ = nullptr;
    double mean_ = 0;
    std::uint64_t passes_ = 0;
};

}  // namespace aips
