// A colour given as a spectrum.
#include "spectral_texture.h"

namespace lxs::shading {

SpectralTexture::SpectralTexture(const Spectrum& spectrum)
    : surface_(colour_of_surface(spectrum)), light_(colour_of_light(spectrum)) {}

}  // namespace lxs::shading
