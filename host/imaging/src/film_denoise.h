// What a film keeps so that its image can be denoised, and the denoised image.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "film_layers.h"
#include "pass_halves.h"
#include "pixel_filter.h"

namespace lxs {

/// Watches the passes that a film gets. It reads the film's sums and never changes them. 152 bytes
/// a pixel beside those of the layers that guide it, 120 without photons.
class FilmDenoise {
  public:
    FilmDenoise(std::uint32_t width, std::uint32_t height, const PixelFilter& filter);

    /// Layers that the film is to be given, beside those that it writes.
    static LayersWanted guides() { return {.albedo = true, .normal = true, .depth = true}; }

    void add_surfaces(std::span<const Vec2> positions, std::span<const SeenSurface> surfaces) {
        guides_.add_surfaces(positions, surfaces);
    }
    void set_wavelengths(const Wavelengths& wavelengths) { guides_.set_wavelengths(wavelengths); }
    /// The pass is over; `film` holds it.
    void end_pass(const FilmAccumulator& film);
    void clear();

    /// Whether there is a denoised image: not before each half has told a variance.
    bool known() const;
    /// Mean over passes, denoised; below zero where negative lobes of the filter have drawn it.
    std::vector<Rgb> image(const FilmAccumulator& film) const;

    /// Throws StateError if what is restored doesn't fit this film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;

  private:
    void end_batch(const FilmAccumulator& film);
    /// Of the passes in closed batches.
    std::vector<Rgb> image() const;
    std::size_t pixels() const { return std::size_t{width_} * height_; }

    std::uint32_t width_, height_;
    FilmLayers guides_;
    HalvesSchedule schedule_;
    HalfMeans image_, albedo_, normal_;
    /// Per half and pixel: sums over batches of what moved the half's mean, squared, as PassBatches
    /// has them, passes alike.
    std::array<std::vector<std::array<float, 3>>, 2> squares_;
};

}  // namespace lxs
