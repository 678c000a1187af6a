// A film in memory: box-filtered pixels, with the two means that the engine asks for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "aips/adapter/camera.h"

namespace aips {

/// The weighted mean of what fell into each pixel, light groups apart, in double precision.
class PixelMean {
  public:
    PixelMean(std::uint32_t width, std::uint32_t height, std::uint32_t groups = 1);
    /// Adds radiance[i * groups + group] at positions[i]. Throws std::invalid_argument unless there
    /// is a value of each group for every position.
    void add(std::span<const Vec2> positions, std::span<const Rgb> radiance, double weight);
    /// Number of the pixel that a position is in.
    std::size_t pixel_of(Vec2 position) const;
    /// Adds the means of the light groups [first, last) to `pixels`; nothing where no sample fell.
    void add_to(std::vector<Rgb>& pixels, std::uint32_t first, std::uint32_t last) const;
    /// All groups together, row by row from the top.
    std::vector<Rgb> image() const;
    /// Mean luminance of image().
    double mean() const;

  private:
    std::uint32_t width_, height_, groups_;
    std::vector<double> sums_;     // [(pixel * groups + group) * 3 + channel]
    std::vector<double> weights_;  // [pixel]
};

/// The image is the plain mean over passes of what eye paths saw, plus the weighted mean of what
/// photons brought; light groups and extra layers apart.
class ImageFilm : public Film {
  public:
    ImageFilm(std::uint32_t width, std::uint32_t height, std::uint32_t groups = 1);
    std::uint32_t width() const override { return width_; }
    std::uint32_t height() const override { return height_; }
    /// Throws std::invalid_argument unless the pass has the film's light groups and a value of each
    /// for every sample.
    void add_pass(const FilmPass& pass) override;
    bool takes_splats() const override { return true; }
    /// Throws std::invalid_argument unless there is a value for each sample.
    void add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                        std::span<const Rgb> values, double weight) override;
    /// Throws std::invalid_argument unless there is a value for each pixel.
    void set_layer(std::string_view name, std::span<const float> values) override;

    /// Linear radiance, row by row from the top, all light groups together; black where no sample
    /// fell.
    std::vector<Rgb> image() const;
    std::vector<Rgb> image_of_group(std::uint32_t group) const;
    /// Its part that eye paths saw without photons, splats among it.
    std::vector<Rgb> eye_part() const;
    /// Mean luminance of the image.
    double mean() const;

    /// Extra layers by name.
    const std::map<std::string, PixelMean, std::less<>>& color_layers() const {
        return color_layers_;
    }
    const std::map<std::string, std::vector<float>, std::less<>>& layers() const { return layers_; }

  private:
    std::uint32_t width_, height_, groups_;
    void add_splats(const FilmSplats& splats);
    void add_splats_to(std::vector<Rgb>& pixels, std::uint32_t first, std::uint32_t last) const;

    PixelMean eye_, photons_;
    std::vector<double> splats_;  // [(pixel * groups + group) * 3 + channel]; empty without any
    std::uint64_t splat_passes_ = 0;
    std::map<std::string, PixelMean, std::less<>> color_layers_;
    std::map<std::string, std::vector<float>, std::less<>> layers_;
};

}  // namespace aips
