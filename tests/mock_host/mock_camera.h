// Camera, sampler, film and log of the mock host.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "aips/adapter/camera.h"

namespace mock {

/// Pinhole camera: `right` and `down` span half of the image plane at distance 1 along `forward`.
class Camera final : public aips::Camera {
  public:
    Camera(aips::Vec3 eye, aips::Vec3 forward, aips::Vec3 right, aips::Vec3 down,
           std::uint32_t width, std::uint32_t height)
        : eye_(eye),
          forward_(forward),
          right_(right),
          down_(down),
          width_(width),
          height_(height) {}
    aips::CameraRay generate(const aips::CameraSample& sample, float time) const override;
    float shutter_open() const override { return 0; }
    float shutter_close() const override { return 1; }

  private:
    aips::Vec3 eye_, forward_, right_, down_;
    std::uint32_t width_, height_;
};

/// Uniform positions within each pixel, different for every sample number.
class Sampler final : public aips::Sampler {
  public:
    explicit Sampler(std::uint64_t seed) : seed_(seed) {}
    aips::CameraSample camera_sample(std::uint64_t number, std::uint32_t x,
                                     std::uint32_t y) const override;

  private:
    std::uint64_t seed_;
};

/// Box-filtered image, the sum of weighted means over passes of what eye paths saw and of what
/// photons brought; light groups apart.
class Film final : public aips::Film {
  public:
    Film(std::uint32_t width, std::uint32_t height, std::uint32_t groups = 1);
    std::uint32_t width() const override { return width_; }
    std::uint32_t height() const override { return height_; }
    void add_pass(const aips::FilmPass& pass) override;
    void add_layer_pass(std::string_view name, std::span<const aips::Vec2> positions,
                        std::span<const aips::Rgb> values, double weight) override;
    void set_layer(std::string_view name, std::span<const float> values) override;

    /// Mean over all samples, row by row; of one light group or (default) all together.
    std::vector<aips::Rgb> image(int group = -1) const;
    /// Its part that eye paths saw without photons.
    std::vector<aips::Rgb> eye_part() const;
    /// Mean luminance of the image.
    double mean() const;
    std::uint32_t passes() const { return static_cast<std::uint32_t>(photon_weights_.size()); }
    /// [pass]: weights of the photons' part.
    const std::vector<double>& photon_weights() const { return photon_weights_; }
    /// Extra layers by name: films of colour layers, values of float layers.
    const std::map<std::string, Film, std::less<>>& color_layers() const { return color_layers_; }
    const std::map<std::string, std::vector<float>, std::less<>>& layers() const { return layers_; }

  private:
    struct Mean {
        std::vector<double> sums;     // [(pixel * groups + group) * 3 + channel]
        std::vector<double> weights;  // [pixel]
    };
    void add_to_image(const Mean& mean, int group, std::vector<aips::Rgb>& pixels) const;
    void add(Mean& mean, std::span<const aips::Vec2> positions, std::span<const aips::Rgb> radiance,
             double weight) const;

    std::uint32_t width_, height_, groups_;
    std::vector<double> photon_weights_;
    Mean eye_, photons_;
    std::map<std::string, Film, std::less<>> color_layers_;
    std::map<std::string, std::vector<float>, std::less<>> layers_;
};

/// Keeps what is logged.
class Log final : public aips::Log {
  public:
    void info(std::string_view message) override { lines.emplace_back(message); }
    void warning(std::string_view message) override { lines.emplace_back(message); }
    std::vector<std::string> lines;
};

}  // namespace mock
