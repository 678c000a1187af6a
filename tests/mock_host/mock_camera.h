// Camera and log of the mock host; its sampler and film are ready ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aips/parts/image_film.h"
#include "aips/parts/uniform_sampler.h"

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

using Sampler = aips::UniformSampler;

/// The ready film, and what passes weigh.
class Film final : public aips::ImageFilm {
  public:
    using ImageFilm::ImageFilm;
    void add_pass(const aips::FilmPass& pass) override {
        ImageFilm::add_pass(pass);
        photon_weights_.push_back(pass.photon_weight);
    }
    /// [pass]: weights of the photons' part.
    const std::vector<double>& photon_weights() const { return photon_weights_; }

  private:
    std::vector<double> photon_weights_;
};

/// Keeps what is logged.
class Log final : public aips::Log {
  public:
    void info(std::string_view message) override { lines.emplace_back(message); }
    void warning(std::string_view message) override { lines.emplace_back(message); }
    std::vector<std::string> lines;
};

}  // namespace mock
