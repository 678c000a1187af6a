// LuxRender's scene and film in plain numbers.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "lux_worker.h"

namespace aips::luxrender {

/// Numbers of the film's buffers.
struct FilmBuffers {
    unsigned eye = 0, photons = 0, splats = 0;
};

class SceneView final : public LuxView {
  public:
    /// `scene` outlives it and keeps its film's buffers.
    SceneView(lux::Scene& scene, const FilmBuffers& buffers);

    float sensitivity(float nanometres) const override;
    float shortest_wavelength() const override { return WAVELENGTH_START; }
    float longest_wavelength() const override { return WAVELENGTH_END; }
    void set_wavelengths(const Triple& nanometres, const Triple& per_density) override;

    void bounds(Triple& lower, Triple& upper) const override;
    unsigned light_groups() const override;

    std::size_t surface_bytes() const override { return sizeof(KeptSurface); }
    bool intersect(const ViewRay& ray, void* place, ViewHit& hit) const override;
    bool intersect_shape(const ViewRay& ray, ViewHit& hit) const override;
    Triple visibility(const Triple& from, const Triple& to, const void* volume,
                      float time) const override;

    unsigned lobes(const void* surface) const override;
    Triple evaluate(const void* surface, const Triple& to_light, const Triple& to_eye,
                    unsigned lobes) const override;
    float pdf(const void* surface, const Triple& wo, const Triple& wi,
              unsigned lobes) const override;
    bool sample(const void* surface, const Triple& wo, const float u[3], bool from_eye,
                unsigned lobes, ViewScattering& scattering) const override;

    unsigned light_count() const override;
    unsigned light_group(unsigned light) const override;
    bool light_at_infinity(unsigned light) const override;
    bool light_is_delta(unsigned light) const override;
    bool emit(unsigned light, const float place[3], const float direction[3],
              ViewEmission& emission) const override;
    bool sample_direct(unsigned light, const Triple& from, const float u[3],
                       ViewDirect& sample) const override;
    float pdf_direct(unsigned light, const Triple& from, const Triple& at,
                     const Triple& normal) const override;
    float pdf_escaping(unsigned light, const Triple& from, const Triple& wi) const override;
    Triple escaped(unsigned light, const Triple& direction) const override;

    ViewRay camera_ray(const float film[2], const float lens[2], float time) const override;
    float shutter_open() const override { return shutter_open_; }
    float shutter_close() const override { return shutter_close_; }

    unsigned film_width() const override { return film_.GetXPixelCount(); }
    unsigned film_height() const override { return film_.GetYPixelCount(); }
    void add_sample(FilmPart part, const float position[2], const Triple& radiance, unsigned group,
                    double weight) override;
    void end_film_pass() override;

    void info(const std::string& message) override;
    void warning(const std::string& message) override;

  private:
    /// This thread's worker, ready for use.
    LuxWorker& worker(float time) const;
    /// The same at the pass's time, for lights, which are asked without one. Every pass begins with
    /// rays of the camera, which have it.
    LuxWorker& worker() const;
    LuxWorker& this_threads_worker() const;

    lux::Scene& scene_;
    lux::Film& film_;
    FilmBuffers buffers_;
    float shutter_open_, shutter_close_;
    mutable std::atomic<float> time_;  ///< of the pass
    std::unordered_map<const lux::Light*, int> index_of_;
    luxrays::SpectrumWavelengths wavelengths_;
    Triple per_density_;
    std::uint64_t stamp_ = 0;  ///< of the wavelengths
    std::uint64_t number_;     ///< of this view among all
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<LuxWorker>> workers_;
};

}  // namespace aips::luxrender
