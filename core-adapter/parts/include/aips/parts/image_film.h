// A film in memory: box-filtered pixels, with the two means that the engine asks for.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "aips/adapter/camera.h"

namespace aips {

/// The image is the plain mean over passes of what eye paths saw, plus the weighted mean of what
/// photons brought; light groups and extra layers apart. Sums are in double precision.
class ImageFilm : public Film {
  public:
    ImageFilm(std::uint32_t width, std::uint32_t height, std::uint32_t groups = 1);
    std::uint32_t width() const override { return width_; }
    std::uint32_t height() const override { return height_; }
    void add_pass(const FilmPass& pass) override;
    void add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                        std::span<const Rgb> values, double weight) override;
    /// Throws std::invalid_argument unless there is a value for each pixel.
    void set_layer(std::string_view name, std::span<const float> values) override;

    /// Linear radiance, row by row from the top, all light groups together; black where no sample
    /// fell.
    std::vector<Rgb> image() const;
    std::vector<Rgb> image_of_group(std::uint32_t group) const;
    /// Its part that eye paths saw without photons.
    std::vector<Rgb> eye_part() const;
    /// Mean luminance of the image.
    double mean() const;
    /// [pass]: weights of the photons' part.
    const std::vector<double>& photon_weights() const { return photon_weights_; }

    /// Extra layers by name: films of colour layers, values of float layers.
    const std::map<std::string, ImageFilm, std::less<>>& color_layers() const {
        return color_layers_;
    }
    const std::map<std::string, std::vector<float>, std::less<>>& layers() const { return layers_; }

  private:
    struct Mean {
        std::vector<double> sums;     // [(pixel * groups + group) * 3 + channel]
        std::vector<double> weights;  // [pixel]
    };
    void add(Mean& mean, std::span<const Vec2> positions, std::span<const Rgb> radiance,
             double weight) const;
    void add_to_image(const Mean& mean, std::uint32_t first, std::uint32_t last,
                      std::vector<Rgb>& pixels) const;

    std::uint32_t width_, height_, groups_;
    std::vector<double> photon_weights_;
    Mean eye_, photons_;
    std::map<std::string, ImageFilm, std::less<>> color_layers_;
    std::map<std::string, std::vector<float>, std::less<>> layers_;
};

}  // namespace aips
