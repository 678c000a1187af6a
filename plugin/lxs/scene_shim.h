// The engine's scene, camera, sampler, film and log on top of the host's SDK.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "aips/adapter/camera.h"
#include "aips/adapter/scene.h"
#include "lxs/sdk/integrator.h"

namespace aips::shim {

/// The host's scene as the engine sees it.
class SceneShim final : public Scene {
  public:
    explicit SceneShim(const lxs::Scene& scene);
    ~SceneShim() override;

    bool intersect(const Ray& ray, SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override;
    bool intersect_shape(const Ray& ray, SurfacePoint& point,
                         std::pmr::memory_resource& memory) const override;
    bool intersect_specular(const Ray& ray, SurfacePoint& point,
                            std::pmr::memory_resource& memory) const override;
    Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const override;
    Rgb visibility(const SurfacePoint& point, const DirectSample& light, float time) const override;
    bool blocked(Vec3 from, Vec3 to, float time) const override;
    std::span<const Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override {
        return static_cast<std::uint32_t>(scene_.light_groups().size());
    }
    Bounds bounds() const override;
    SceneFacts facts() const override;
    const Media* media() const override { return media_.get(); }

  private:
    /// `met`: what the host said. Returns it.
    bool take(bool met, const lxs::SurfaceHit& hit, SurfacePoint& point,
              std::pmr::memory_resource& memory) const;

    const lxs::Scene& scene_;
    std::unique_ptr<Media> media_;  // null if no medium scatters
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<const Light*> light_pointers_;
    std::unordered_map<const lxs::Light*, LightIndex> index_of_;
};

class CameraShim final : public Camera {
  public:
    explicit CameraShim(const lxs::Camera& camera) : camera_(camera) {}
    CameraRay generate(const CameraSample& sample, float time) const override;
    float shutter_open() const override { return camera_.shutter_open(); }
    float shutter_close() const override { return camera_.shutter_close(); }

  private:
    const lxs::Camera& camera_;
};

class SamplerShim final : public Sampler {
  public:
    explicit SamplerShim(const lxs::Sampler& sampler) : sampler_(sampler) {}
    CameraSample camera_sample(std::uint64_t number, std::uint32_t x,
                               std::uint32_t y) const override;

  private:
    const lxs::Sampler& sampler_;
};

class FilmShim final : public Film {
  public:
    explicit FilmShim(lxs::Film& film) : film_(film) {}
    std::uint32_t width() const override { return film_.width(); }
    std::uint32_t height() const override { return film_.height(); }
    void add_pass(const FilmPass& pass) override;
    bool takes_splats() const override { return true; }
    LayersWanted layers_wanted() const override;
    void add_parts(const FilmPass& parts) override;
    void add_surfaces(std::span<const Vec2> positions,
                      std::span<const SeenSurface> surfaces) override;
    void add_bias(const BiasSamples& samples) override;
    void add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                        std::span<const Rgb> values, double weight) override;
    void set_layer(std::string_view name, std::span<const float> values) override {
        film_.set_layer(name, values);
    }

  private:
    /// In the host's terms, until the next of its kind.
    lxs::PassSamples samples_of(const FilmPass& pass);
    lxs::PassSplats splats_of(const FilmPass& pass);

    lxs::Film& film_;
    std::vector<lxs::Vec2> positions_;
    std::vector<lxs::Rgb> radiance_, photons_;
    std::vector<lxs::SeenSurface> surfaces_;
};

/// The engine speaks of its inner workings: for who asks for more than usual.
class LogShim final : public Log {
  public:
    explicit LogShim(lxs::Log& log) : log_(log) {}
    void info(std::string_view message) override { log_.debug(message); }
    void warning(std::string_view message) override { log_.warning(message); }

  private:
    lxs::Log& log_;
};

}  // namespace aips::shim
