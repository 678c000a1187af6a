// A light as a spectral render sees it: what it emits, at the wavelengths of the pass.
#include "spectral_light.h"

namespace lxs {

bool SpectralLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    if (!light_.sample_emission(u, sample)) return false;
    sample.power = at_wavelengths(sample.power);
    return !is_black(sample.power);
}

bool SpectralLight::sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                                  DirectSample& sample) const {
    if (!light_.sample_direct(p, n, u, sample)) return false;
    sample.radiance = at_wavelengths(sample.radiance);
    return true;
}

}  // namespace lxs
