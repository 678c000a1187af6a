// LuxRender's scene in plain numbers: wavelengths, geometry, camera. Materials, lights and film are
// in files of their own.
#include "scene_view.h"

#include <algorithm>
#include <limits>

namespace aips::luxrender {
namespace {

using luxrays::SpectrumWavelengths;
using luxrays::SWCSpectrum;

std::uint64_t next_view_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

/// The volume that the ray travelled in, which the surface tells if the ray does not know. As
/// materials ask the surface for both of its sides, it is told the ray's if it does not know.
const lux::Volume* settle_volume(const luxrays::Ray& ray, const void* of_ray,
                                 lux::Intersection& met) {
    auto volume = static_cast<const lux::Volume*>(of_ray);
    const bool from_behind = Dot(ray.d, met.dg.nn) > 0.f;
    const lux::Volume*& side = from_behind ? met.interior : met.exterior;
    if (!volume) {
        volume = side;
    } else if (!side) {
        side = volume;
    }
    return volume;
}

Triple passing(const lux::Volume* volume, const luxrays::Ray& ray,
               const SpectrumWavelengths& wavelengths) {
    if (!volume) return {{1, 1, 1}};
    return triple_of(Exp(-volume->Tau(wavelengths, ray)));
}

luxrays::Ray lux_ray(const ViewRay& ray) {
    luxrays::Ray r(point_of(ray.origin), vector_of(ray.direction));
    r.time = ray.time;
    return r;
}

}  // namespace

SceneView::SceneView(lux::Scene& scene, const FilmBuffers& buffers)
    : scene_(scene),
      film_(*scene.camera()->film),
      buffers_(buffers),
      shutter_open_(scene.camera["ShutterOpen"].FloatValue()),
      shutter_close_(scene.camera["ShutterClose"].FloatValue()),
      time_(shutter_open_),
      number_(next_view_number()) {
    for (const auto& light : scene.lights)
        index_of_.emplace(light.get(), static_cast<int>(index_of_.size()));
    set_wavelengths({{600, 550, 450}}, {{1, 1, 1}});
}

float SceneView::sensitivity(float nanometres) const {
    return SpectrumWavelengths::spd_ciex.Sample(nanometres) +
           SpectrumWavelengths::spd_ciey.Sample(nanometres) +
           SpectrumWavelengths::spd_ciez.Sample(nanometres);
}

void SceneView::set_wavelengths(const Triple& nanometres, const Triple& per_density) {
    SpectrumWavelengths& w = wavelengths_;
    w.single = false;
    w.single_w = 0;
    for (unsigned i = 0; i < WAVELENGTH_SAMPLES; ++i)
        w.w[i] = nanometres.v[i < 3 ? i : 1];
    SpectrumWavelengths::spd_w.Offsets(WAVELENGTH_SAMPLES, w.w, w.binsRGB, w.offsetsRGB);
    SpectrumWavelengths::spd_ciex.Offsets(WAVELENGTH_SAMPLES, w.w, w.binsXYZ, w.offsetsXYZ);
    per_density_ = per_density;
    ++stamp_;
}

LuxWorker& SceneView::this_threads_worker() const {
    struct Mine {
        std::uint64_t view = 0;
        LuxWorker* worker = nullptr;
    };
    thread_local Mine mine;
    if (mine.view != number_) {
        const std::lock_guard<std::mutex> lock(mutex_);
        workers_.push_back(std::make_unique<LuxWorker>(scene_, workers_.size() + 1));
        mine = {number_, workers_.back().get()};
    }
    return *mine.worker;
}

LuxWorker& SceneView::worker(float time) const {
    // All threads store the same; most find it there.
    if (time_.load(std::memory_order_relaxed) != time) time_.store(time, std::memory_order_relaxed);
    LuxWorker& w = this_threads_worker();
    w.begin(wavelengths_, stamp_, time);
    return w;
}

LuxWorker& SceneView::worker() const {
    LuxWorker& w = this_threads_worker();
    w.begin(wavelengths_, stamp_, time_.load(std::memory_order_relaxed));
    return w;
}

void SceneView::bounds(Triple& lower, Triple& upper) const {
    const luxrays::BBox box = scene_.aggregate->WorldBound();
    lower = triple_of(box.pMin);
    upper = triple_of(box.pMax);
}

unsigned SceneView::light_groups() const {
    return std::max<unsigned>(1, static_cast<unsigned>(scene_.lightGroups.size()));
}

bool SceneView::intersect(const ViewRay& ray, void* place, ViewHit& hit) const {
    LuxWorker& w = worker(ray.time);
    auto& kept = *new (place) KeptSurface{w.next_number(), lux_ray(ray), {}, ray.component};
    if (!scene_.Intersect(kept.ray, &kept.met)) {
        hit.distance = std::numeric_limits<float>::infinity();
        hit.transmittance =
            passing(static_cast<const lux::Volume*>(ray.volume), kept.ray, w.sample.swl);
        return false;
    }
    const lux::Volume* const volume = settle_volume(kept.ray, ray.volume, kept.met);
    hit.distance = kept.ray.maxt;
    // LuxRender's own margin goes by the position alone; intersections of a curved surface err by
    // the way that the ray has come.
    hit.error = std::max(luxrays::MachineEpsilon::E(kept.met.dg.p),
                         luxrays::MachineEpsilon::E(kept.ray.maxt));
    hit.transmittance = passing(volume, kept.ray, w.sample.swl);
    const lux::BSDF& bsdf = w.bsdf_of(kept);
    hit.position = triple_of(kept.met.dg.p);
    hit.geometric_normal = triple_of(bsdf.ng);
    const lux::Normal& shading = bsdf.dgShading.nn;
    hit.shading_normal = triple_of(Dot(shading, bsdf.ng) < 0.f ? -shading : shading);
    hit.interior = bsdf.interior;
    hit.exterior = bsdf.exterior;
    const auto light = index_of_.find(kept.met.arealight);
    if (kept.met.arealight && light != index_of_.end()) {
        hit.light = light->second;
        SWCSpectrum emitted(1.f);
        lux::BSDF* of_light = nullptr;
        if (kept.met.Le(w.sample, kept.ray, &of_light, nullptr, nullptr, &emitted))
            hit.emitted = triple_of(emitted);
    }
    return true;
}

bool SceneView::intersect_shape(const ViewRay& ray, ViewHit& hit) const {
    const luxrays::Ray r = lux_ray(ray);
    lux::Intersection met;
    if (!scene_.Intersect(r, &met)) return false;
    hit.position = triple_of(met.dg.p);
    hit.geometric_normal = triple_of(met.dg.nn);
    hit.distance = r.maxt;
    return true;
}

Triple SceneView::visibility(const Triple& from, const Triple& to, const void* volume,
                             float time) const {
    LuxWorker& w = worker(time);
    SWCSpectrum passed(1.f);
    if (!scene_.Connect(w.sample, static_cast<const lux::Volume*>(volume), false, false,
                        point_of(from), point_of(to), false, &passed, nullptr, nullptr)) {
        return {};
    }
    w.sample.swl.single = false;
    return triple_of(passed);
}

ViewRay SceneView::camera_ray(const float film[2], const float lens[2], float time) const {
    LuxWorker& w = worker(time);
    w.sample.imageX = film[0] + float(film_.GetXPixelStart());
    w.sample.imageY = film[1] + float(film_.GetYPixelStart());
    w.sample.lensU = lens[0];
    w.sample.lensV = lens[1];
    luxrays::Ray ray;
    float x = 0, y = 0;
    w.sample.camera->GenerateRay(scene_, w.sample, &ray, &x, &y);
    ViewRay camera_ray;
    // The near clipping plane is where the ray begins.
    camera_ray.origin = triple_of(ray(ray.mint));
    camera_ray.direction = triple_of(ray.d);
    camera_ray.time = time;
    camera_ray.volume = w.sample.camera->GetVolume();
    return camera_ray;
}

}  // namespace aips::luxrender
