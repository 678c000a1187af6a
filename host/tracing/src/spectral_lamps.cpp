// The lamps of a scene whose light is given as a spectrum, at the wavelengths of the pass.
#include "spectral_lamps.h"

namespace lxs {

const Rgb* SpectralLamps::add(const CurvePointer& spectrum) {
    if (!spectrum) return nullptr;
    const auto found = lamps_.find(spectrum);
    if (found != lamps_.end()) return &found->second.value;
    return &lamps_.emplace(spectrum, Lamp{relative_to_daylight(*spectrum)}).first->second.value;
}

void SpectralLamps::set_wavelengths(const Wavelengths& wavelengths) {
    for (auto& [spectrum, lamp] : lamps_)
        lamp.value = lamp.relative.amounts_at(wavelengths);
}

}  // namespace lxs
