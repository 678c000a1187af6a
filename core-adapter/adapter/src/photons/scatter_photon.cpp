// One bounce of a photon.
#include "photons/scatter_photon.h"

#include <cmath>
#include <limits>

#include "aips/core/chains/primary_path.h"
#include "aips/core/sampling/sampling.h"

namespace aips {
namespace {

/// A Bsdf sample over the lobes in `mask` as it is.
template <class Numbers>
bool scatter_by_bsdf(const SurfacePoint& point, Vec3 wo, LobeMask mask, float mask_pdf,
                     Numbers& random, ScatteredPhoton& result) {
    const Vec2 u = random.next2();
    BsdfSample sample;
    if (!point.bsdf->sample(wo, u, random.next(), Transport::Power, mask, sample)) return false;
    result.lobe = sample.lobe;
    result.direction = sample.wi;
    result.weight = sample.weight * (adjoint_shading_factor(point, wo, sample.wi) / mask_pdf);
    result.straight = sample.straight;
    result.component = sample.component;
    return true;
}

/// Probability of bouncing by a specular lobe where both kinds are present, by albedo.
float specular_probability(const Bsdf& bsdf, Vec3 wo, LobeMask lobes) {
    if (!(lobes & kSpecular)) return 0;
    const float specular = luminance(bsdf.albedo(wo, kSpecular));
    const float other = luminance(bsdf.albedo(wo, lobes & kNonSpecular));
    if (!(specular + other > 0) || !std::isfinite(specular + other)) return 0.5f;
    return std::clamp(specular / (specular + other), 0.1f, 0.9f);
}

/// Cosine about the geometric normal: on the side that the photon came from, or on both alike.
struct CosineDirections {
    Vec3 normal;  // on that side
    bool both_sides = false;

    /// `u_side` in [0, 1) tells which side.
    Vec3 sample(float u_side, Vec2 u) const {
        const Vec3 side = both_sides && u_side < 0.5f ? -normal : normal;
        return Frame(side).to_world(square_to_cosine_hemisphere(u));
    }
    float pdf(Vec3 wi) const {
        const float cosine = dot(wi, normal);
        return (both_sides ? 0.5f * std::abs(cosine) : std::max(0.0f, cosine)) * kInvPi;
    }
};

/// Densities that a direction is drawn from, one of them at random.
struct Mixture {
    const GuidedDirections* guided = nullptr;
    float guided_share = 0;
    CosineDirections cosine;
    float cosine_share = 0;
    float mask_pdf = 1;  // probability of having come to non-specular lobes at all
};

/// Adds the cosine about the geometric normal where the shading normal is tilted against it. A Bsdf
/// draws by the cosine to the shading normal; the quotient of the two cosines in
/// adjoint_shading_factor then has no bound, nor the photon's power a finite variance. With this
/// share diffuse lobes' weights are bounded; behind the surface too, where they let light through.
void add_cosine(const SurfacePoint& point, Vec3 wo, LobeMask lobes, Mixture& mixture) {
    if (point.geometric_normal == point.shading_normal || !(lobes & kDiffuse)) return;
    const float diffuse = luminance(point.bsdf->albedo(wo, kDiffuse));
    const float all = luminance(point.bsdf->albedo(wo, lobes & kNonSpecular));
    const float share = diffuse / all;
    if (!(share > 0)) return;
    const Vec3 normal = normal_towards(wo, point);
    mixture.cosine = {normal, point.bsdf->pdf(wo, -normal, kDiffuse) > 0};
    mixture.cosine_share = 0.5f * std::min(share, 1.0f);
}

/// One-sample mixture of guide, cosine and Bsdf, weighed by the density of all together, so that
/// any shares leave the expectation as it is.
///
/// Bound on fireflies: the density is at least 1 - guided_share of what it would be without the
/// guide, so a bounce multiplies a photon's power by at most 1 / (1 - guided_share) times as much
/// as without (4 by bounce tables, whose greatest share is 3/4; 100 by guideshare 0.99).
template <class Numbers>
bool scatter_by_mixture(const Mixture& mixture, const SurfacePoint& point, Vec3 wo, Numbers& random,
                        PhotonCounts& counts, ScatteredPhoton& result) {
    const float rest = 1 - mixture.guided_share;
    const float by_cosine = rest * mixture.cosine_share;
    const float u_choice = random.next();
    const Vec2 u = random.next2();
    const float u_lobe = random.next();
    Vec3 wi;
    if (mixture.guided && u_choice < mixture.guided_share) {
        wi = mixture.guided->sample(u);
        ++counts.guided_bounces;
    } else if (u_choice < mixture.guided_share + by_cosine) {
        wi = mixture.cosine.sample((u_choice - mixture.guided_share) / by_cosine, u);
    } else {
        BsdfSample sample;
        if (!point.bsdf->sample(wo, u, u_lobe, Transport::Power, kNonSpecular, sample)) {
            return false;
        }
        wi = sample.wi;
    }
    const float bsdf_pdf = point.bsdf->pdf(wo, wi, kNonSpecular);
    float pdf = (rest - by_cosine) * bsdf_pdf;
    if (by_cosine > 0) pdf += by_cosine * mixture.cosine.pdf(wi);
    const float plain_pdf = pdf / rest;
    if (mixture.guided) pdf += mixture.guided_share * mixture.guided->pdf(wi);
    if (!std::isfinite(pdf) || bsdf_pdf < 0) {
        // No density: the photon is not lost in silence, its power is refused and counted.
        const float none = std::numeric_limits<float>::quiet_NaN();
        result.weight = {none, none, none};
        return true;
    }
    if (!(pdf * mixture.mask_pdf > 0)) return false;
    const float cosine = abs_dot(wi, point.shading_normal);
    result.direction = wi;
    result.weight = point.bsdf->evaluate(wo, wi, Transport::Power, kNonSpecular) *
                    (cosine * adjoint_shading_factor(point, wo, wi) / (pdf * mixture.mask_pdf));
    result.straight = false;
    result.pdf = pdf;
    result.plain_pdf = plain_pdf;
    return !is_black(result.weight);
}

}  // namespace

float adjoint_shading_factor(const SurfacePoint& point, Vec3 wo, Vec3 wi) {
    if (point.geometric_normal == point.shading_normal) return 1;
    const float shading = abs_dot(wi, point.shading_normal);
    if (!(shading > 0)) return 0;
    return normal_ratio(point, wo) * (abs_dot(wi, point.geometric_normal) / shading);
}

template <class Numbers>
bool scatter_photon(const PhotonInput& in, const SurfacePoint& point, Vec3 wo, Numbers& random,
                    Arena& arena, PhotonCounts& counts, ScatteredPhoton& result) {
    const LobeMask lobes = point.bsdf->lobes();
    Mixture mixture;
    if (lobes & kNonSpecular) {
        if (in.guide) {
            mixture.guided = in.guide->directions(
                {point.position, point.shading_normal, wo, point.bsdf, normal_towards(wo, point)},
                arena);
        }
        mixture.guided_share = mixture.guided ? mixture.guided->share() : 0;
        add_cosine(point, wo, lobes, mixture);
    }
    if (mixture.guided || mixture.cosine_share > 0) {
        const float specular = specular_probability(*point.bsdf, wo, lobes);
        if (specular > 0 && random.next() < specular) {
            return scatter_by_bsdf(point, wo, kSpecular, specular, random, result);
        }
        ++counts.bounces;
        mixture.mask_pdf = 1 - specular;
        return scatter_by_mixture(mixture, point, wo, random, counts, result);
    }
    const bool scattered = scatter_by_bsdf(point, wo, lobes, 1, random, result);
    if (result.lobe & kNonSpecular) ++counts.bounces;
    return scattered;
}

template bool scatter_photon(const PhotonInput&, const SurfacePoint&, Vec3, RandomStream&, Arena&,
                             PhotonCounts&, ScatteredPhoton&);
template bool scatter_photon(const PhotonInput&, const SurfacePoint&, Vec3, PrimaryPath&, Arena&,
                             PhotonCounts&, ScatteredPhoton&);

}  // namespace aips
