// One bounce of a photon.
#include "scatter_photon.h"

#include "aips/core/primary_path.h"

namespace aips {
namespace {

/// A Bsdf sample over the lobes in `mask` as it is.
template <class Numbers>
bool scatter_by_bsdf(const SurfacePoint& point, Vec3 wo, LobeMask mask, float mask_pdf,
                     Numbers& random, ScatteredPhoton& result, LobeMask& lobe) {
    const Vec2 u = random.next2();
    BsdfSample sample;
    if (!point.bsdf->sample(wo, u, random.next(), Transport::Power, mask, sample)) return false;
    lobe = sample.lobe;
    result.direction = sample.wi;
    result.weight = sample.weight * (adjoint_shading_factor(point, wo, sample.wi) / mask_pdf);
    result.straight = sample.straight;
    return true;
}

/// Probability of bouncing by a specular lobe where both kinds are present, by albedo.
float specular_probability(const Bsdf& bsdf, Vec3 wo, LobeMask lobes) {
    if (!(lobes & kSpecular)) return 0;
    const float specular = luminance(bsdf.albedo(wo, kSpecular));
    const float other = luminance(bsdf.albedo(wo, lobes & kNonSpecular));
    if (!(specular + other > 0)) return 0.5f;
    return std::clamp(specular / (specular + other), 0.1f, 0.9f);
}

/// One-sample mixture: the guide with probability `share`, else the Bsdf; weighed by the density
/// of both together, so that any guide leaves the expectation as it is.
template <class Numbers>
bool scatter_by_mixture(const GuidedDirections& guided, float share, const SurfacePoint& point,
                        Vec3 wo, float mask_pdf, Numbers& random, PhotonCounts& counts,
                        ScatteredPhoton& result) {
    const float u_choice = random.next();
    const Vec2 u = random.next2();
    const float u_lobe = random.next();
    Vec3 wi;
    if (u_choice < share) {
        wi = guided.sample(u);
        ++counts.guided_bounces;
    } else {
        BsdfSample sample;
        if (!point.bsdf->sample(wo, u, u_lobe, Transport::Power, kNonSpecular, sample)) {
            return false;
        }
        wi = sample.wi;
    }
    const float pdf =
        mask_pdf * (share * guided.pdf(wi) + (1 - share) * point.bsdf->pdf(wo, wi, kNonSpecular));
    if (!(pdf > 0)) return false;
    const float cosine = abs_dot(wi, point.shading_normal);
    result.direction = wi;
    result.weight = point.bsdf->evaluate(wo, wi, Transport::Power, kNonSpecular) *
                    (cosine * adjoint_shading_factor(point, wo, wi) / pdf);
    result.straight = false;
    return !is_black(result.weight);
}

}  // namespace

float adjoint_shading_factor(const SurfacePoint& point, Vec3 wo, Vec3 wi) {
    if (point.geometric_normal == point.shading_normal) return 1;
    const float out = abs_dot(wi, point.geometric_normal) * abs_dot(wo, point.shading_normal);
    const float in = abs_dot(wo, point.geometric_normal) * abs_dot(wi, point.shading_normal);
    return in > 0 ? out / in : 0;
}

template <class Numbers>
bool scatter_photon(const PhotonInput& in, const SurfacePoint& point, Vec3 wo, Numbers& random,
                    Arena& arena, PhotonCounts& counts, ScatteredPhoton& result) {
    const LobeMask lobes = point.bsdf->lobes();
    LobeMask lobe = 0;
    if (in.guide && (lobes & kNonSpecular)) {
        const GuidedDirections* guided =
            in.guide->directions({point.position, point.shading_normal, wo, point.bsdf}, arena);
        if (guided) {
            const float specular = specular_probability(*point.bsdf, wo, lobes);
            if (specular > 0 && random.next() < specular) {
                return scatter_by_bsdf(point, wo, kSpecular, specular, random, result, lobe);
            }
            ++counts.bounces;
            return scatter_by_mixture(*guided, float(in.settings.guide_share), point, wo,
                                      1 - specular, random, counts, result);
        }
    }
    const bool scattered = scatter_by_bsdf(point, wo, lobes, 1, random, result, lobe);
    if (lobe & kNonSpecular) ++counts.bounces;
    return scattered;
}

template bool scatter_photon(const PhotonInput&, const SurfacePoint&, Vec3, RandomStream&, Arena&,
                             PhotonCounts&, ScatteredPhoton&);
template bool scatter_photon(const PhotonInput&, const SurfacePoint&, Vec3, PrimaryPath&, Arena&,
                             PhotonCounts&, ScatteredPhoton&);

}  // namespace aips
