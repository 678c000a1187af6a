// The mock host's medium: one fog that fills the whole scene.
#pragma once

#include "aips/adapter/media.h"

namespace mock {

/// Coefficients per unit of distance, and the mean cosine of scattering.
struct Fog {
    aips::Rgb absorption, scattering;
    float asymmetry = 0;

    aips::Rgb extinction() const { return absorption + scattering; }
    aips::Rgb transmittance(float distance) const;
};

class Scene;

/// Fog in all of a scene, whatever rays are marked with.
class Media final : public aips::Media {
  public:
    Media(const Scene& scene, const Fog& fog) : scene_(scene), fog_(fog) {}

    bool scatters(const void*) const override { return !is_black(fog_.scattering); }
    aips::Rgb extinction(const void*) const override { return fog_.extinction(); }
    aips::Rgb scattering(const void*) const override { return fog_.scattering; }
    aips::Flight sample_flight(const void*, const aips::Ray&, float segment, aips::Rgb carried,
                               aips::Vec2 u) const override;
    aips::Rgb phase(const void*, float cosine) const override;
    aips::PhaseSample sample_phase(const void*, aips::Vec3 direction, aips::Rgb carried,
                                   aips::Vec2 u) const override;
    aips::Rgb visibility(const void*, aips::Vec3 from, const aips::DirectSample& light,
                         float time) const override;

  private:
    const Scene& scene_;
    Fog fog_;
};

}  // namespace mock
