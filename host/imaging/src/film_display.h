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
///
/// Where outliers are to be left out, samples are kept apart by their brightness (Zirr, Hanika and
/// Dachsbacher 2018, "Re-weighting firefly samples for improved finite-sample Monte Carlo
/// estimates"), and a brightness of which few samples lie around a pixel counts for little there:
/// not at all for one alone, in full for one with as many others as asked for. Then it takes 76
/// bytes in place of 16.
class FilmDisplay {
  public:
    /// `neighbours`: others of its kind that a sample needs to count in full; 0: none.
    FilmDisplay(std::uint32_t width, std::uint32_t height, const PixelFilter& filter,
                std::uint32_t neighbours = 0);

    /// As FilmAccumulator::set_conversion.
    void set_conversion(const Imath::M33d& to_rgb) { to_rgb_ = to_rgb; }
    /// Adds what `film`, which has it already, has sorted into its cells.
    void add(const PassSamples& pass, const FilmAccumulator& film);
    void add_splats(const PassSplats& splats, const FilmAccumulator& film);
    void clear();

    bool rejects() const { return neighbours_ > 0; }
    /// Per pixel; `film` has got the same samples.
    std::vector<Rgb> image(const FilmAccumulator& film) const;
    /// The same without outliers.
    std::vector<Rgb> image_without_outliers(const FilmAccumulator& film) const;

    /// Throws StateError if what is restored doesn't fit this film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;

  private:
    /// A weighted mean over passes, as far as they have come; by brightness.
    struct Mean {
        std::vector<float> weights;            ///< [pixel]; empty: no pass has had this part
        std::vector<std::vector<Rgb>> levels;  ///< [level][pixel], whose sum the mean is
        double least = 0;                      ///< brightness of the lowest level; 0: none yet
        double samples_per_pixel = 0;
    };
    /// Where a sample goes: a share to a level, the rest to the next.
    struct Place {
        std::uint8_t level = 0;
        float share = 1;
    };

    void add_part(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance, double weight,
                  const SampleCells& cells, const FilterIntegral* integral);
    void find_places(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance,
                     double scale, std::size_t samples);
    std::vector<Rgb> reliable(const Mean& mean) const;
    /// Sum of first, second and splats, by `part(mean, pixel)`.
    template <class Part>
    std::vector<Rgb> sum_of_parts(const FilmAccumulator& film, const Part& part) const;
    std::size_t pixels() const { return std::size_t{width_} * height_; }

    std::uint32_t width_, height_;
    PixelFilter filter_;
    FilterIntegral integral_;
    std::uint32_t neighbours_;
    std::optional<Imath::M33d> to_rgb_;  ///< none: samples are RGB
    Mean first_, second_, splats_;
    std::vector<Place> places_;  ///< of the samples that are added; empty: all in one level
};

/// Puts what is displayed of a pixel in the place of what was measured where the filter's negative
/// lobes have taken much of it. `image` is what was measured, `lobe_free` a FilmDisplay's of the
/// same samples; `shown`, that or a denoised one, is made no darker. All in one set of colours.
void show_without_lobes(std::span<Rgb> shown, std::span<const Rgb> image,
                        std::span<const Rgb> lobe_free);

/// What of an image is shown where outliers are left out.
struct Rejection {
    std::span<const Rgb> all, kept;  ///< a FilmDisplay's image with and without outliers
    std::uint32_t width;
    std::uint32_t reach;  ///< of the filter that made `shown`, pixels
};
/// Takes outliers, and the rings that the filter's lobes have made around them, out of `shown`.
void show_without_outliers(std::span<Rgb> shown, const Rejection& rejection);

/// Share of the light that `kept` lacks of `all`.
double share_left_out(std::span<const Rgb> all, std::span<const Rgb> kept);

}  // namespace lxs
