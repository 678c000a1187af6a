// LuxRender's camera, film and log as the engine sees them.
#pragma once

#include "aips/adapter/camera.h"
#include "lux_view.h"

namespace aips::luxrender {

class CameraShim final : public Camera {
  public:
    explicit CameraShim(const LuxView& view) : view_(view) {}
    /// Footprints are measured by the rays of the next pixels.
    CameraRay generate(const CameraSample& sample, float time) const override;
    float shutter_open() const override { return view_.shutter_open(); }
    float shutter_close() const override { return view_.shutter_close(); }

  private:
    const LuxView& view_;
};

/// Three means of the film: eye paths, photons by their passes' weights, splats.
class FilmShim final : public Film {
  public:
    explicit FilmShim(LuxView& view) : view_(view) {}
    std::uint32_t width() const override { return view_.film_width(); }
    std::uint32_t height() const override { return view_.film_height(); }
    void add_pass(const FilmPass& pass) override;
    bool takes_splats() const override { return true; }
    /// LuxRender's film has no layers beside the image.
    void add_layer_pass(std::string_view, std::span<const Vec2>, std::span<const Rgb>,
                        double) override {}
    void set_layer(std::string_view, std::span<const float>) override {}

  private:
    LuxView& view_;
};

class LogShim final : public Log {
  public:
    explicit LogShim(LuxView& view) : view_(view) {}
    void info(std::string_view message) override { view_.info(std::string(message)); }
    void warning(std::string_view message) override { view_.warning(std::string(message)); }

  private:
    LuxView& view_;
};

}  // namespace aips::luxrender
