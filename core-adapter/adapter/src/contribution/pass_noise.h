// How much noise a pass has, and how much of it is its photons'.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contribution/constants.h"
#include "contribution/pixel_importance.h"
#include "estimate/gather.h"

namespace aips {

/// Relative variances of pixels in a pass, averaged over the image. No pixel counts for more than
/// kMostOfAPixel: few, with emitters in glass or metal, have most of the variance otherwise.
struct PassNoise {
    double all = 0;          ///< what two passes differ by
    double photon_path = 0;  ///< of a single photon path, of what photons bring to surfaces
    double beam_path = 0;    ///< the same in media, if beams took all photons
};

/// Variances of what photons bring to each eye path: of its luminance on surfaces and in media.
struct PhotonVariances {
    std::vector<float> surfaces, beams;  ///< [eye path]; empty: not asked for
    std::uint32_t thinning = 1;          ///< photons in media of which beams took one

    std::size_t memory_bytes() const {
        return (surfaces.capacity() + beams.capacity()) * sizeof(float);
    }
};

/// A pixel's variance, or what two passes differ by squared, no more than kMostOfAPixel by its
/// weight.
inline double trimmed(double squared, double weight) {
    return weight * squared > kMostOfAPixel ? kMostOfAPixel / weight : squared;
}

/// Fills `variances`, one for each eye path, with those of the luminance that photons bring to its
/// visible point: `photons`, for each eye path and light group, without light in media, made of
/// `flux`. Reuses the memory.
void photon_variances(const EyeImage& image, std::span<const Rgb> photons, const PhotonFlux& flux,
                      std::vector<float>& variances);

/// Compares each pass with the one before. The photons' noise is known from the squares of what
/// they bring, as they come one by one.
class PassNoiseMeter {
  public:
    PassNoiseMeter(std::uint32_t width, std::uint32_t height);

    /// Noise of this pass and the last together; all zero after the first. `seen`: what its eye
    /// paths saw; `variances`: of the same eye paths; `importance`: of earlier passes.
    PassNoise add_pass(std::span<const PixelLuminance> seen, const PhotonVariances& variances,
                       std::uint64_t photon_paths, const PixelImportance& importance);

    /// Saves the last pass's pixels, or restores them into a new meter for the same film.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    /// Of one pass, so that single precision does for variances: of n eye paths in the pixel it
    /// is off by n 2^-24 at most.
    struct Pixel {
        double sum = 0;                   // luminance over its eye paths
        float variance = 0, of_beam = 0;  // of the sum, the photons' parts
        std::uint32_t paths = 0;
    };
    struct Differences {
        double all = 0, photon_path = 0, beam_path = 0;  // weighed
        double pixels = 0;                               // that were compared

        Differences& operator+=(const Differences& other) {
            all += other.all;
            photon_path += other.photon_path;
            beam_path += other.beam_path;
            pixels += other.pixels;
            return *this;
        }
    };
    void sum_pixels(std::span<const PixelLuminance> seen, const PhotonVariances& variances);
    /// Sums of what pixels [first, last) differ by, for the present pass's `photon_paths`.
    Differences compare(std::size_t first, std::size_t last, std::uint64_t photon_paths,
                        const PixelImportance& importance) const;

    std::vector<Pixel> pixels_, last_;  // [pixel] of this pass and the one before
    std::uint64_t last_paths_ = 0;      // photon paths of the pass before
};

}  // namespace aips
