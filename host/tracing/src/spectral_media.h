// The media of a scene as a spectral render sees them: coefficients at the wavelengths of the pass.
#pragma once

#include <memory>
#include <vector>

#include "lxs/scene/scene_medium.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

class SpectralMedia {
  public:
    /// Keeps the coefficients that the media have now: those of R, G and B.
    explicit SpectralMedia(const std::vector<SceneMedium>& media);

    /// Gives the media coefficients at `wavelengths`; nobody may use them meanwhile.
    void set_wavelengths(const Wavelengths& wavelengths);

  private:
    struct Coloured {
        SceneMedium scene;
        MediumCoefficients rgb;
    };
    std::vector<Coloured> media_;
};

}  // namespace lxs
