// Whether a scene has colours given as spectra, and whether RGB represents them.
#include "spectral_need.h"

#include <algorithm>

namespace lxs {

void add_once(const CurvePointer& spectrum, std::vector<CurvePointer>& list) {
    if (!spectrum || std::find(list.begin(), list.end(), spectrum) != list.end()) return;
    list.push_back(spectrum);
}

SpectralNeed spectral_need(const SceneSpectra& spectra) {
    SpectralNeed need;
    if (spectra.empty()) return need;
    std::vector<RepresentedSpectrum> given, lamps, surfaces;
    for (const CurvePointer& lamp : spectra.lamps)
        given.push_back(represented_lamp(*lamp));
    for (const CurvePointer& surface : spectra.surfaces)
        surfaces.push_back(represented_surface(*surface));
    for (const CurvePointer& medium : spectra.media)
        surfaces.push_back(represented_medium(*medium));
    need.given = true;
    need.worst = worst_pair(given, plain_surfaces());
    lamps = given;
    if (spectra.has_plain_lamps) lamps.push_back(white_lamp());
    const Misrepresentation other = worst_pair(lamps, surfaces);
    if (need.worst.pair.empty() || other.difference > need.worst.difference) need.worst = other;
    return need;
}

}  // namespace lxs
