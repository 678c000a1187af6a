// The media of a scene as a spectral render sees them: coefficients at the wavelengths of the pass.
#include "spectral_media.h"

namespace lxs {

SpectralMedia::SpectralMedia(const std::vector<std::shared_ptr<Medium>>& media) {
    for (const auto& medium : media)
        media_.push_back({medium, medium->coefficients()});
}

void SpectralMedia::set_wavelengths(const Wavelengths& wavelengths) {
    for (const Coloured& coloured : media_) {
        const MediumCoefficients& rgb = coloured.rgb;
        coloured.medium->set_coefficients({wavelengths.values_of(rgb.absorption),
                                           wavelengths.values_of(rgb.scattering),
                                           wavelengths.values_of(rgb.asymmetry)});
    }
}

}  // namespace lxs
