// What each thread has of LuxRender: a sample to hand to its functions, and materials of late.
#pragma once

#include "lux_headers.h"

namespace aips::luxrender {

/// What intersect() keeps of a surface. LuxRender's materials build their BSDF in an arena of
/// theirs; it is built anew from this where it is asked for after others.
struct KeptSurface {
    std::uint64_t number;  ///< unlike that of any other
    luxrays::Ray ray;
    lux::Intersection met;
    int component;  ///< as ViewRay has it
};

/// Used by one thread.
class LuxWorker {
  public:
    /// Numbers of kept surfaces begin with `index`.
    LuxWorker(const lux::Scene& scene, std::uint64_t index);

    /// Frees what earlier calls built, but for materials, and sets wavelengths and time.
    void begin(const luxrays::SpectrumWavelengths& wavelengths, std::uint64_t stamp, float time);
    /// The surface's BSDF, valid until three others were asked for.
    const lux::BSDF& bsdf_of(const KeptSurface& surface);
    std::uint64_t next_number() { return ++number_; }

    lux::Sample sample;

  private:
    struct Built {
        luxrays::MemoryArena arena{4096};
        std::uint64_t number = 0, stamp = 0;
        const lux::BSDF* bsdf = nullptr;
    };
    static constexpr unsigned kBuilt = 4;

    std::uint64_t number_, stamp_ = 0;
    Built built_[kBuilt];
    unsigned oldest_ = 0;
};

/// Wavelengths of a path for as long as it lives: all of them, or the one that dispersion left.
class ComponentScope {
  public:
    ComponentScope(luxrays::SpectrumWavelengths& wavelengths, int component)
        : wavelengths_(wavelengths) {
        wavelengths_.single = component >= 0;
        wavelengths_.single_w = component >= 0 ? static_cast<unsigned>(component) : 0u;
    }
    ~ComponentScope() { wavelengths_.single = false; }
    ComponentScope(const ComponentScope&) = delete;
    ComponentScope& operator=(const ComponentScope&) = delete;

  private:
    luxrays::SpectrumWavelengths& wavelengths_;
};

}  // namespace aips::luxrender
