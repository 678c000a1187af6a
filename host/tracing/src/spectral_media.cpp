// The media of a scene as a spectral render sees them: coefficients at the wavelengths of the pass.
#include "spectral_media.h"

namespace lxs {
namespace {

/// A coefficient at the wavelengths: by its spectrum, or else by that of its colour.
Rgb at(const Wavelengths& wavelengths, const CurvePointer& spectrum, const Rgb& rgb) {
    return spectrum ? spectrum->amounts_at(wavelengths) : wavelengths.values_of(rgb);
}

}  // namespace

SpectralMedia::SpectralMedia(const std::vector<SceneMedium>& media) {
    for (const SceneMedium& medium : media)
        media_.push_back({medium, medium.medium->coefficients()});
}

void SpectralMedia::set_wavelengths(const Wavelengths& wavelengths) {
    for (const Coloured& coloured : media_) {
        const auto& medium = coloured.scene.medium;
        const MediumSpectra& spectra = coloured.scene.spectra;
        if (medium->varies()) {
            medium->set_wavelengths(&wavelengths);
            continue;
        }
        const MediumCoefficients& rgb = coloured.rgb;
        medium->set_coefficients({at(wavelengths, spectra.absorption, rgb.absorption),
                                  at(wavelengths, spectra.scattering, rgb.scattering),
                                  wavelengths.values_of(rgb.asymmetry),
                                  wavelengths.values_of(rgb.emission)});
    }
}

}  // namespace lxs
