// What each thread has of LuxRender.
#include "lux_worker.h"

namespace aips::luxrender {

LuxWorker::LuxWorker(const lux::Scene& scene, std::uint64_t index) : number_(index << 40) {
    sample.camera = scene.camera()->Clone();
    sample.rng = nullptr;
    sample.contribBuffer = nullptr;
    sample.sampler = nullptr;
    sample.realTime = sample.time = 0;
    sample.camera->SampleMotion(sample.realTime);
}

void LuxWorker::begin(const luxrays::SpectrumWavelengths& wavelengths, std::uint64_t stamp,
                      float time) {
    sample.arena.FreeAll();
    if (stamp_ != stamp) {
        sample.swl = wavelengths;
        stamp_ = stamp;
    }
    if (sample.realTime != time) {
        sample.realTime = sample.time = time;
        sample.camera->SampleMotion(time);
    }
}

const lux::BSDF& LuxWorker::bsdf_of(const KeptSurface& surface) {
    for (const Built& built : built_)
        if (built.number == surface.number && built.stamp == stamp_) return *built.bsdf;
    Built& built = built_[oldest_];
    oldest_ = (oldest_ + 1) % kBuilt;
    built.arena.FreeAll();
    const ComponentScope scope(sample.swl, surface.component);
    built.bsdf = surface.met.GetBSDF(built.arena, sample.swl, surface.ray);
    built.number = surface.number;
    built.stamp = stamp_;
    return *built.bsdf;
}

}  // namespace aips::luxrender
