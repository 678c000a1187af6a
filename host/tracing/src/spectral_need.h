// Whether a scene has colours given as spectra, and whether RGB represents them.
#pragma once

#include <vector>

#include "lxs/tracing/trace_scene.h"

namespace lxs {

/// Colours of a scene that are given as spectra, each once.
struct SceneSpectra {
    std::vector<CurvePointer> lamps, surfaces, media;  ///< in the order of the scene
    bool has_plain_lamps = false;  ///< some light's colour is not given as a spectrum

    bool empty() const { return lamps.empty() && surfaces.empty() && media.empty(); }
};

/// Adds `spectrum`, if there is one that the list hasn't yet.
void add_once(const CurvePointer& spectrum, std::vector<CurvePointer>& list);

/// Compares all lamps on all surfaces and through all media.
SpectralNeed spectral_need(const SceneSpectra& spectra);

}  // namespace lxs
