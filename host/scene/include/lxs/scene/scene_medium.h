// A medium as a scene names it: what integrators see, and the spectra of its coefficients.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/medium.h"
#include "lxs/spectrum/spectral_curve.h"

namespace lxs {

/// The coefficients of a medium that are given as spectra; null for those that are colours.
struct MediumSpectra {
    CurvePointer absorption, scattering;
};

struct SceneMedium {
    std::shared_ptr<Medium> medium;
    MediumSpectra spectra;
    std::string name = {};    ///< as the scene calls it
    std::uint32_t group = 0;  ///< light group of what it emits
    SourceLocation where = {};

    SceneMedium(std::shared_ptr<Medium> plain, MediumSpectra given = {})
        : medium(std::move(plain)), spectra(std::move(given)) {}
};

}  // namespace lxs
