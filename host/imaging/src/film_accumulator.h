// Sums of filtered samples per pixel and light group, over all passes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "filter_integral.h"
#include "lxs/sdk/film.h"
#include "lxs/sdk/state_archive.h"
#include "negative_lobes.h"
#include "pixel_filter.h"
#include "sample_cells.h"

namespace lxs {

/// The two means over passes whose sum a pixel is, all light groups together, splats within the
/// first; not cut at zero. A weight is the sum of filter times pass weight that a mean rests on,
/// 0 for none; passes, where there are splats alone.
struct PixelMeans {
    std::array<Imath::V3d, 2> value{Imath::V3d(0.0), Imath::V3d(0.0)};
    std::array<double, 2> weight{};
};

/// Those from `first` to before `end`.
struct LightGroups {
    std::uint32_t first, end;
};

/// Estimates each pixel as sum(f w L) / sum(f w) over all samples: f the filter, w the weight of
/// the sample's pass; likewise of what passes bring as their second part, and both are added.
/// Splats are kept apart and added too (see Film::add_splats). Each pixel gathers its samples in a
/// fixed order (that of SampleCells), so that the bits depend on neither the number of threads nor
/// their schedule. Sums are in double precision: 10^4 passes stay far below a float's rounding.
class FilmAccumulator {
  public:
    FilmAccumulator(std::uint32_t width, std::uint32_t height, std::uint32_t groups,
                    const PixelFilter& filter);

    /// From now on samples hold values at wavelengths: a row vector of them times `to_rgb` is
    /// linear RGB. Each part is divided by its mean over passes of `white`, what a white of 1 has
    /// become, which the few wavelengths of few passes would tint; it tends to 1 with the passes.
    /// Right to the last digit where all pixels get the same passes. Splats are taken to come with
    /// each pass, and divided as its first part is.
    void set_conversion(const Imath::M33d& to_rgb, const Imath::V3d& white) {
        to_rgb_ = to_rgb;
        white_of_pass_ = white;
    }

    /// Throws std::invalid_argument if the pass is malformed (sizes, groups, weights): a bug of the
    /// caller. Samples that are not finite or negative are refused whole and counted.
    void add(const PassSamples& pass);
    /// Likewise, by the rule of Film::add_splats.
    void add_splats(const PassSplats& splats);
    /// Forgets all samples and splats; the count of refused ones stays.
    void clear();

    /// Mean of one light group, or of the sum of all, per pixel; never negative or infinite. What
    /// negative lobes of the filter would draw below zero is settled with the pixels around (see
    /// redistribute_negative_lobes), in each image by itself: sums over neighbourhoods are those of
    /// the samples.
    void resolve_group(std::uint32_t group, std::span<Rgb> image) const;
    void resolve_total(std::span<Rgb> image) const;
    PixelMeans means(std::size_t pixel) const;
    /// Settles what is below zero in an image of denoised means likewise, and keeps what the
    /// filter's lobes make dark (see keep_dark_beside_bright).
    void settle_denoised(std::span<Rgb> image) const;
    bool has_second() const { return !second_.sums.empty(); }
    /// What a white of 1 is in the mean of the first or the second part (see set_conversion).
    Imath::V3d white(std::size_t part) const;
    /// The samples or splats that were added last.
    const SampleCells& cells() const { return cells_; }

    /// Saves or restores all sums and counts; of the same image size, groups and filter.
    void state(StateArchive& archive);
    std::uint64_t refused_samples() const;
    /// Samples refused for what they brought of each light group, each counted once; the last
    /// entry: for their position.
    std::span<const std::uint64_t> refused_by_group() const { return cells_.refused(); }
    /// Bytes held at one sample per pixel and pass, or more if a pass brought more.
    std::size_t memory_bytes() const;

  private:
    /// A weighted mean over passes.
    struct Mean {
        /// Per pixel: sum of weights, then the weighted sums R, G, B of each light group.
        std::vector<double> sums;
        Imath::V3d white_sum{0.0};  ///< over passes, weight times a white of 1 as RGB
        double weight_sum = 0;      ///< of the passes in white_sum
    };

    void check_size(StateArchive& archive) const;
    void check_sums() const;
    void begin_second();
    void begin_splats();
    void reserve_rows(bool second);
    std::span<double> row_pixel(std::uint32_t y);
    void gather_pixel(const PassSamples& pass, std::uint32_t x, std::uint32_t y,
                      std::span<double> pixel) const;
    void gather_row(const PassSamples& pass, std::uint32_t y, std::span<double> pixel);
    void gather_splats(const PassSamples& pass, std::uint32_t y, std::span<double> pixel);
    void add_pixel(Mean& mean, std::size_t index, double weight, double filter_sum,
                   std::span<double> colors) const;
    void convert(std::span<double> colors) const;
    double filter_on_film(std::uint32_t x, std::uint32_t y) const;
    Imath::V3d mean_value(const Mean& mean, std::size_t pixel, LightGroups groups) const;
    Imath::V3d splat_value(std::size_t pixel, LightGroups groups) const;
    Rgb resolve(std::size_t pixel, LightGroups groups) const;
    void resolve_groups(LightGroups groups, std::span<Rgb> image) const;
    void settle(std::span<Rgb> image) const;
    FilteredImage filtered(std::span<Rgb> image) const;

    std::uint32_t width_, height_, groups_;
    PixelFilter filter_;
    SampleCells cells_;
    Mean first_;
    Mean second_;  ///< its sums are empty until a pass has a second part
    /// Per pixel: sums of f * radiance / F, as R, G, B of each light group. Empty without splats.
    std::vector<double> splats_;
    double splat_samples_ = 0;
    std::optional<FilterIntegral> filter_integral_;
    std::optional<Imath::M33d> to_rgb_;  ///< none: samples are RGB
    Imath::V3d white_of_pass_{1.0};
    /// Per row, the sums of the pixel being gathered: of f, and of f * radiance of each part. Kept
    /// between passes, so that passes after the first allocate nothing.
    std::vector<double> row_pixels_;
};

}  // namespace lxs
