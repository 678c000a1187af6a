// The film that writes image files (LuxRender's "fleximage").
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "color_space.h"
#include "film_accumulator.h"
#include "film_bias.h"
#include "film_denoise.h"
#include "film_display.h"
#include "film_error.h"
#include "film_layers.h"
#include "film_settings.h"
#include "lxs/imaging/imaging.h"
#include "pixel_filter.h"
#include "tone_map.h"

namespace lxs {

class FlexImage final : public FileFilm {
  public:
    FlexImage(FilmSettings settings, std::vector<std::string> group_names,
              const PixelFilter& filter)
        : settings_(std::move(settings)),
          group_names_(std::move(group_names)),
          filter_(filter),
          accumulator_(width(), height(), light_groups(), filter) {
        if (settings_.layers != LayersWanted{})
            asked_.emplace(settings_.layers, width(), height(), filter);
        if (settings_.layers.bias) bias_.emplace(width(), height());
        if (filter.has_negative_weights() || settings_.outlier_neighbours > 0)
            display_.emplace(width(), height(), filter, settings_.outlier_neighbours);
    }

    std::uint32_t width() const override { return settings_.frame.width; }
    std::uint32_t height() const override { return settings_.frame.height; }
    std::uint32_t light_groups() const override {
        return static_cast<std::uint32_t>(group_names_.size());
    }
    LayersWanted layers_wanted() const override;
    void add_pass(const PassSamples& samples) override;
    void add_splats(const PassSplats& splats) override;
    void add_layer_pass(std::string_view name, const PassSamples& samples) override;
    void add_parts(const PassSamples& parts) override {
        if (asked_) asked_->add_parts(parts);
    }
    void add_splats_of_parts(const PassSplats& parts) override {
        if (asked_) asked_->add_splats_of_parts(parts);
    }
    void add_surfaces(std::span<const Vec2> positions,
                      std::span<const SeenSurface> surfaces) override {
        if (asked_) asked_->add_surfaces(positions, surfaces);
        if (denoise_) denoise_->add_surfaces(positions, surfaces);
    }
    void add_bias(const PassSamples& samples) override {
        if (bias_) bias_->add(samples);
    }
    void clear() override;
    void set_layer(std::string_view name, std::span<const float> values) override;

    std::string base_name() const override { return settings_.base_name; }
    double halt_time_seconds() const override { return settings_.halt_time_seconds; }
    std::uint64_t halt_passes() const override { return settings_.halt_passes; }
    double write_interval_seconds() const override { return settings_.write_interval_seconds; }
    double display_interval_seconds() const override { return settings_.display_interval_seconds; }
    double halt_error() const override { return settings_.halt_error; }
    void estimate_errors(bool wanted) override;
    void keep_for_denoising(bool wanted) override;
    void end_pass() override;
    std::optional<ErrorEstimate> error() const override;
    std::uint64_t refused_samples() const override;
    InvalidSampleList invalid_samples() const override;
    std::size_t memory_bytes() const override;

    void state(StateArchive& archive) override;
    void set_wavelengths(const Wavelengths& wavelengths) override;
    void set_names(std::span<const std::string> objects,
                   std::span<const std::string> materials) override {
        if (asked_) asked_->set_names(objects, materials);
    }
    bool hides_background() const override { return settings_.hides_background; }
    void set_exposure(double stops) override { settings_.tone_map.exposure_stops = stops; }
    std::vector<Rgb> image() const override;
    std::vector<std::string> held_layers() const override;
    HeldLayer held_layer(std::string_view name) const override;
    std::vector<Rgb> denoised() const override;
    std::vector<Rgb> shown() const override;
    std::optional<double> outliers_left_out() const override;
    std::vector<std::uint8_t> tone_mapped() const override {
        return tone_map(shown(), settings_.tone_map);
    }
    std::string_view tone_map_kernel() const override { return name(settings_.tone_map.kernel); }
    FileLayers file_layers(const ImageMetadata& metadata,
                           std::span<const Rgb> denoised) const override;
    void write_png(const std::string& path, std::span<const Rgb> denoised) const override;

  private:
    /// Of each pixel's mean over passes, in the file and for who looks on.
    static constexpr std::string_view kErrorLayer = "error";

    FilmAccumulator& color_layer(std::string_view name);
    bool names_layer(std::string_view name) const;
    bool is_asked(std::string_view name) const;
    bool has_error_layer() const;
    void color_layers_state(StateArchive& archive);
    void float_layers_state(StateArchive& archive);
    /// The sums of an accumulator as the film's colours.
    template <class Resolve>
    std::vector<Rgb> film_colors(const Resolve& resolve) const {
        std::vector<Rgb> values(pixels());
        resolve(values);
        to_film_colors(values);
        return values;
    }
    std::vector<Rgb> bias_colors() const;
    std::vector<Rgb> shown(std::span<const Rgb> denoised,
                           std::vector<Rgb>* with_outliers = nullptr) const;
    void to_film_colors(std::span<Rgb> values) const {
        if (!settings_.to_film_colors) return;
        for (Rgb& c : values)
            c = (*settings_.to_film_colors)(c);
    }
    std::size_t pixels() const { return std::size_t{width()} * height(); }

    FilmSettings settings_;
    std::vector<std::string> group_names_;
    PixelFilter filter_;
    FilmAccumulator accumulator_;
    std::map<std::string, FilmAccumulator, std::less<>> color_layers_;
    std::map<std::string, std::vector<float>, std::less<>> layers_;
    std::map<std::string, std::uint64_t> refused_layer_values_;  ///< by float layer
    std::optional<Wavelengths> wavelengths_;                     ///< none: passes are RGB
    std::optional<FilmError> error_;                             ///< none: not estimated
    std::optional<FilmBias> bias_;                               ///< none: not wanted
    std::optional<FilmLayers> asked_;                            ///< none: no layers are wanted
    std::optional<FilmDenoise> denoise_;                         ///< none: not to be denoised
    std::optional<FilmDisplay> display_;                         ///< none: shown as it is
};

}  // namespace lxs
