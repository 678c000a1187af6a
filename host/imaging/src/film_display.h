// What a film's samples show when they are displayed, beside the image that is measured.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "film_accumulator.h"
#include "filter_integral.h"
#include "lxs/sdk/film.h"
#include "lxs/sdk/state_archive.h"
#include "pixel_filter.h"
#include "sample_cells.h"

namespace lxs {

/// The same means as a FilmAccumulator's, of the sum of all light groups, by the central lobe of
/// the filter: nothing is drawn below zero beside what is bright. 16 bytes a pixel, 32 with second
/// parts, 16 more with splats. It reads what the film gets and never changes it.
class FilmDisplay {
  public:
    FilmDisplay(std::uint32_t width, std::uint32_t height, const PixelFilter& filter);

    /// As FilmAccumulator::set_conversion.
    void set_conversion(const Imath::M33d& to_rgb) { to_rgb_ = to_rgb; }
    /// Adds what `film`, which has it already, has sorted into its cells.
    void add(const PassSamples& pass, const FilmAccumulator& film);
    void add_splats(const PassSplats& splats, const FilmAccumulator& film);
    void clear();

    /// Per pixel; `film` has got the same samples.
    std::vector<Rgb> image(const FilmAccumulator& film) const;

    /// Throws StateError if what is restored doesn't fit this film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;

  private:
    /// A weighted mean over passes, as far as they have come.
    struct Mean {
        std::vector<float> weights;  ///< [pixel]; empty: no pass has had this part
        std::vector<Rgb> values;     ///< [pixel]
    };

    void add_part(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance, double weight,
                  const SampleCells& cells, const FilterIntegral* integral);
    std::size_t pixels() const { return std::size_t{width_} * height_; }

    std::uint32_t width_, height_;
    PixelFilter filter_;
    FilterIntegral integral_;
    std::optional<Imath::M33d> to_rgb_;  ///< none: samples are RGB
    Mean first_, second_, splats_;
};

/// Puts what is displayed of a pixel in the place of what was measured where the filter's negative
/// lobes have taken much of it. `image` is what was measured, `lobe_free` a FilmDisplay's of the
/// same samples; `shown`, that or a denoised one, is made no darker. All in one set of colours.
void show_without_lobes(std::span<Rgb> shown, std::span<const Rgb> image,
                        std::span<const Rgb> lobe_free);

}  // namespace lxs
