// LuxRender's materials in plain numbers.
//
// LuxRender's F() is f times the cosine of the direction to the light, SampleF() that over the
// density; `reverse` tells that the known direction goes to the eye, and leaves out the factor of
// shading normals, which is the engine's business.
#include <cmath>

#include "scene_view.h"

namespace aips::luxrender {
namespace {

using luxrays::SWCSpectrum;
using luxrays::Vector;

constexpr unsigned kComponents = 3;

lux::BxDFType flags_of(unsigned lobes) {
    return lux::BxDFType(lux::BSDF_REFLECTION | lux::BSDF_TRANSMISSION |
                         (lobes & kDiffuseLobe ? lux::BSDF_DIFFUSE : 0) |
                         (lobes & kGlossyLobe ? lux::BSDF_GLOSSY : 0) |
                         (lobes & kSpecularLobe ? lux::BSDF_SPECULAR : 0));
}

const KeptSurface& kept_at(const void* surface) {
    return *static_cast<const KeptSurface*>(surface);
}

/// Whether shadow rays pass straight on what was sampled.
bool passes_straight(const lux::BSDF& bsdf, const luxrays::SpectrumWavelengths& wavelengths,
                     lux::BxDFType type, const Vector& wo, const Vector& wi, bool from_eye) {
    constexpr auto kThrough = lux::BxDFType(lux::BSDF_SPECULAR | lux::BSDF_TRANSMISSION);
    if ((type & kThrough) != kThrough || Dot(wo, wi) > -0.9999f) return false;
    return !(from_eye ? bsdf.F(wavelengths, wi, wo, true, kThrough)
                      : bsdf.F(wavelengths, wo, wi, true, kThrough))
                .Black();
}

}  // namespace

unsigned SceneView::lobes(const void* surface) const {
    const lux::BSDF& bsdf = worker().bsdf_of(kept_at(surface));
    unsigned lobes = 0;
    for (const unsigned lobe : {kDiffuseLobe, kGlossyLobe, kSpecularLobe})
        if (bsdf.NumComponents(flags_of(lobe)) > 0) lobes |= lobe;
    return lobes;
}

Triple SceneView::evaluate(const void* surface, const Triple& to_light, const Triple& to_eye,
                           unsigned lobes) const {
    LuxWorker& w = worker();
    const KeptSurface& kept = kept_at(surface);
    const lux::BSDF& bsdf = w.bsdf_of(kept);
    const Vector light = vector_of(to_light), eye = vector_of(to_eye);
    const float cosine = AbsDot(light, bsdf.dgShading.nn);
    if (!(cosine > 1e-6f)) return {};
    luxrays::SpectrumWavelengths& wavelengths = w.sample.swl;
    const auto value = [&](int component) {
        const ComponentScope scope(wavelengths, component);
        Triple f = triple_of(bsdf.F(wavelengths, light, eye, true, flags_of(lobes)) / cosine);
        if (wavelengths.single)
            for (unsigned k = 0; k < kComponents; ++k)
                if (k != wavelengths.single_w) f.v[k] = 0;
        return std::make_pair(f, wavelengths.single);
    };
    auto [f, one_only] = value(kept.component);
    if (kept.component < 0 && one_only) {
        for (unsigned k = 1; k < kComponents; ++k)
            f.v[k] = value(static_cast<int>(k)).first.v[k];
    }
    return f;
}

float SceneView::pdf(const void* surface, const Triple& wo, const Triple& wi,
                     unsigned lobes) const {
    LuxWorker& w = worker();
    const KeptSurface& kept = kept_at(surface);
    const lux::BSDF& bsdf = w.bsdf_of(kept);
    luxrays::SpectrumWavelengths& wavelengths = w.sample.swl;
    const auto density = [&](int component) {
        const ComponentScope scope(wavelengths, component);
        const float pdf = bsdf.Pdf(wavelengths, vector_of(wo), vector_of(wi), flags_of(lobes));
        return std::make_pair(std::isfinite(pdf) ? pdf : 0.f, wavelengths.single);
    };
    auto [sum, one_only] = density(kept.component);
    if (kept.component >= 0 || !one_only) return sum;
    for (unsigned k = 1; k < kComponents; ++k)
        sum += density(static_cast<int>(k)).first;
    return sum / kComponents;
}

bool SceneView::sample(const void* surface, const Triple& wo, const float u[3], bool from_eye,
                       unsigned lobes, ViewScattering& scattering) const {
    LuxWorker& w = worker();
    const KeptSurface& kept = kept_at(surface);
    const lux::BSDF& bsdf = w.bsdf_of(kept);
    luxrays::SpectrumWavelengths& wavelengths = w.sample.swl;
    const ComponentScope scope(wavelengths, kept.component);
    // Where a material disperses, it goes on with the component named here.
    float whole;
    const float choice = std::modf(u[2] * 4099.f, &whole);
    const int chosen = std::min(static_cast<int>(choice * kComponents), int(kComponents) - 1);
    if (kept.component < 0) wavelengths.single_w = static_cast<unsigned>(chosen);
    const Vector o = vector_of(wo);
    Vector i;
    SWCSpectrum value;
    float pdf = 0;
    lux::BxDFType type = lux::BxDFType(0);
    if (!bsdf.SampleF(wavelengths, o, &i, u[0], u[1], u[2], &value, &pdf, flags_of(lobes), &type,
                      nullptr, from_eye)) {
        return false;
    }
    const bool specular = type & lux::BSDF_SPECULAR;
    if (!specular && !(pdf > 0.f && std::isfinite(pdf))) return false;
    if (!from_eye) {
        // Undoes the factor of shading normals.
        const float under = AbsDot(o, bsdf.dgShading.nn) * AbsDot(i, bsdf.ng);
        if (!(under > 0.f)) return false;
        value *= AbsDot(i, bsdf.dgShading.nn) * AbsDot(o, bsdf.ng) / under;
    }
    scattering.wi = triple_of(i);
    scattering.weight = triple_of(value);
    scattering.pdf = specular ? 0.f : pdf;
    scattering.lobe = specular                   ? kSpecularLobe
                      : type & lux::BSDF_DIFFUSE ? kDiffuseLobe
                                                 : kGlossyLobe;
    scattering.straight = passes_straight(bsdf, wavelengths, type, o, i, from_eye);
    if (kept.component < 0 && wavelengths.single) {
        scattering.component = chosen;
        for (unsigned k = 0; k < kComponents; ++k)
            scattering.weight.v[k] *= int(k) == chosen ? float(kComponents) : 0.f;
    }
    return true;
}

}  // namespace aips::luxrender
