// A colour given as a spectrum.
#include "spectral_texture.h"

namespace lxs::shading {

SpectralTexture::SpectralTexture(const Spectrum& spectrum, std::string name)
    : surface_(colour_of_surface(spectrum)),
      light_(colour_of_light(spectrum)),
      curve_(std::make_shared<SpectralCurve>(spectrum, std::move(name))) {}

}  // namespace lxs::shading
