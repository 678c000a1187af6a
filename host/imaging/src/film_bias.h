// What the radius of photons does to an image, as far as passes tell.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "film_accumulator.h"
#include "pass_halves.h"

namespace lxs {

inline constexpr std::string_view kBiasLayer = "bias";

/// The bias of each pixel's mean over passes, and its square. Blur grows
/// with the area of a gather disc as long as light has the same curvature all over it: what the
/// whole disc brings less what the inner half of its area does is then half of the bias. Radii fall
/// from pass to pass, so that the bias of the mean is the mean of the passes' biases. What both
/// halves of the passes tell of it has noise of its own in each: their product has none in the
/// mean. A pixel has its own samples alone, whatever the image's filter. It takes 96 bytes a pixel.
class FilmBias {
  public:
    FilmBias(std::uint32_t width, std::uint32_t height);

    /// As Film::add_bias.
    void add(const PassSamples& samples);
    /// The pass is over.
    void end_pass();
    void clear();
    /// As FileFilm::set_wavelengths.
    void set_conversion(const Imath::M33d& to_rgb, const Imath::V3d& white) {
        discs_.set_conversion(to_rgb, white);
    }

    /// Bias of each pixel, radiance of the scene's colours: below zero where the image is too dark.
    void values(std::span<Rgb> values) const;
    /// Whether its square is known: not before the second pass, nor without photons.
    bool known() const { return schedule_.passes(0) > 0 && schedule_.passes(1) > 0; }
    /// Squared bias of each pixel; by chance it may be below zero.
    void squares(std::span<Rgb> values) const;

    std::uint64_t refused_samples() const { return discs_.refused_samples(); }
    /// Throws StateError if what is restored doesn't fit this film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const { return discs_.memory_bytes() + halves_.memory_bytes(); }

  private:
    PixelMeans mean(std::size_t pixel) const;

    FilmAccumulator discs_;  ///< first part: of halves, second: of whole discs
    HalvesSchedule schedule_;
    HalfMeans halves_;
    bool brought_ = false;  ///< whether the pass under way has photons
};

}  // namespace lxs
