// LuxRender's material at one point as the engine sees it.
#include "bsdf_shim.h"

#include <algorithm>
#include <iterator>

#include "convert.h"

namespace aips::luxrender {

static_assert(kDiffuse == kDiffuseLobe && kGlossy == kGlossyLobe && kSpecular == kSpecularLobe);

Rgb BsdfShim::evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const {
    const bool eye = transport == Transport::Radiance;
    const unsigned lobes = mask & unsigned(kNonSpecular);
    if (lobes == 0) return {};
    return rgb_of(view_.evaluate(surface_, to(eye ? wi : wo), to(eye ? wo : wi), lobes));
}

float BsdfShim::pdf(Vec3 wo, Vec3 wi, LobeMask mask) const {
    return view_.pdf(surface_, to(wo), to(wi), mask);
}

bool BsdfShim::sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                      BsdfSample& sample) const {
    const float numbers[3] = {u.x, u.y, u_lobe};
    ViewScattering s;
    if (!view_.sample(surface_, to(wo), numbers, transport == Transport::Radiance, mask, s)) {
        return false;
    }
    sample.wi = vector_of(s.wi);
    sample.weight = rgb_of(s.weight);
    sample.pdf = s.pdf;
    sample.lobe = static_cast<LobeMask>(s.lobe);
    sample.straight = s.straight;
    sample.component = static_cast<std::int8_t>(s.component);
    return true;
}

Rgb BsdfShim::albedo(Vec3 wo, LobeMask mask) const {
    static constexpr float kNumbers[][3] = {
        {0.125f, 0.75f, 0.1f}, {0.375f, 0.25f, 0.5f}, {0.625f, 0.9f, 0.9f}, {0.875f, 0.4f, 0.3f}};
    Rgb sum;
    for (const auto& u : kNumbers) {
        ViewScattering s;
        if (view_.sample(surface_, to(wo), u, true, mask, s)) sum += rgb_of(s.weight);
    }
    const auto share = [](float value) {
        return value > 0 ? std::min(value / float(std::size(kNumbers)), 1.0f) : 0.0f;
    };
    return {share(sum.r), share(sum.g), share(sum.b)};
}

}  // namespace aips::luxrender
