// Rough dielectric interface that bends each wavelength its own way.
#include "dispersive_rough_glass_bsdf.h"

#include <algorithm>
#include <cmath>

#include "lxs/sdk/warp.h"

namespace lxs::shading {

Rgb DispersiveRoughGlassBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                                       LobeMask mask) const {
    Rgb f(0.0f);
    for (int c = first(); c < end(); ++c)
        f[c] = of_component(c).evaluate(wo, wi, transport, mask)[c];
    return f;
}

float DispersiveRoughGlassBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    float sum = 0;
    for (int c = first(); c < end(); ++c)
        sum += of_component(c).pdf(wo, wi, mask);
    return sum / static_cast<float>(end() - first());
}

bool DispersiveRoughGlassBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe,
                                      Transport transport, LobeMask mask,
                                      BsdfSample& sample) const {
    const float choice = u_lobe * static_cast<float>(end() - first());
    const int step = std::min(static_cast<int>(choice), end() - first() - 1);
    const float rest = clamp_to_unit(choice - static_cast<float>(step));
    if (!of_component(first() + step).sample(wo, u, rest, transport, mask, sample)) return false;
    sample.pdf = pdf(wo, sample.wi, mask);
    if (!(sample.pdf > 0)) return false;
    sample.weight = evaluate(wo, sample.wi, transport, mask) *
                    (std::abs(sample.wi.dot(facets_.ns())) / sample.pdf);
    return true;
}

Rgb DispersiveRoughGlassBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb albedo(0.0f);
    for (int c = first(); c < end(); ++c)
        albedo[c] = of_component(c).albedo(wo, mask)[c];
    return albedo;
}

}  // namespace lxs::shading
