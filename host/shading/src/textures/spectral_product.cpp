// The spectrum of a product of colours.
#include "spectral_product.h"

namespace lxs::shading {
namespace {

/// Of a texture that is the same everywhere.
Spectrum factor(const CurvePointer& curve, const std::optional<Rgb>& colour) {
    if (curve) return [curve](double nm) { return curve->at(nm); };
    return [rgb = Imath::V3d(*colour)](double nm) { return primary_spectra(nm) ^ rgb; };
}

}  // namespace

CurvePointer spectral_product(const ColorTexture& first, const ColorTexture& second) {
    const std::optional<Rgb> a_colour = first.constant(), b_colour = second.constant();
    const CurvePointer a_curve = first.spectrum(), b_curve = second.spectrum();
    if (!a_colour || !b_colour || !(a_curve || b_curve)) return nullptr;
    const Spectrum a = factor(a_curve, a_colour), b = factor(b_curve, b_colour);
    const CurvePointer& named = a_curve ? a_curve : b_curve;
    return std::make_shared<SpectralCurve>([&](double nm) { return a(nm) * b(nm); }, named->name());
}

}  // namespace lxs::shading
