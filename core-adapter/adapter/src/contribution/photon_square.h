// How much of the image photons bring: what it costs in noise if only some passes have any.
#pragma once

#include <span>
#include <vector>

#include "contribution/pixel_importance.h"
#include "estimate/gather.h"

namespace aips {

class PhotonSquare {
  public:
    PhotonSquare(std::uint32_t width, std::uint32_t height);

    /// Of a pass that shot: what its photons brought to each eye path and light group.
    void add_pass(const EyeImage& image, std::span<const Rgb> photons);
    /// Mean over pixels of the squared luminance that photons brought in those passes, as a mean
    /// over them, times the weight of a squared error; begins anew. 0 after none. Noise of the mean
    /// is in it.
    double take(const PixelImportance& importance);

    /// Saves what was added, or restores it for the same film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const { return pixels_.capacity() * sizeof(float); }
    static std::size_t memory_bound_bytes(std::size_t pixels) { return pixels * sizeof(float); }

  private:
    std::uint32_t width_, height_;
    std::vector<float> pixels_;  // sum over passes of the pixel's mean luminance
    std::uint64_t passes_ = 0;
};

}  // namespace aips
