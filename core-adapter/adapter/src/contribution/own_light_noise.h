// Noise of the light that eye paths bring by themselves: emitters that they see, and direct light.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contribution/pixel_importance.h"

namespace aips {

/// Compares what passes saw in each pixel without photons or continued paths. Squares are summed
/// pixel by pixel before those of the worst pixels are cut off: light that one pass in a hundred
/// meets is noise of nearly all pixels, though in each pass of few.
class OwnLightNoise {
  public:
    OwnLightNoise(std::uint32_t width, std::uint32_t height);

    /// What the eye paths of a pass saw. It is compared with the pass before if `importance` has
    /// seen one, and says how much errors weigh.
    void add_pass(const EyeImage& image, const PixelImportance& importance, bool compare);

    /// Mean over pixels of the relative variance in a pass since the last call, none counting for
    /// more than kMostOfOwnLight; 0 if no passes were compared.
    double take();

    /// Saves what later passes go on from, or restores it into one for the same film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    struct Pixel {
        double sum = 0;           // luminance over the eye paths of the last pass
        std::uint32_t paths = 0;  // of it
        float squares = 0;        // weighed, of half of what passes differ by squared
    };
    void sum_pixels(const EyeImage& image);

    std::uint32_t width_, height_;
    std::vector<Pixel> pixels_, now_;  // of the last pass, and of the one that is added
    std::uint64_t compared_ = 0;       // passes since the last call of take()
};

}  // namespace aips
