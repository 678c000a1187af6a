// How eye paths bounce, and what they count of lights that they meet.
#include "eye/path_tip.h"

#include <limits>

namespace aips {

bool bounce(const EyePassInput& in, const SurfacePoint& point, Vec3 wo, const BounceDraw& draw,
            InvalidSampleFilter& filter, PathTip& tip) {
    BsdfSample sample;
    if (!point.bsdf->sample(wo, draw.u, draw.u_lobe, Transport::Radiance, draw.mask, sample))
        return false;
    const bool scatters = !sample.straight && sample.lobe != kSpecular;
    tip.throughput = (scatters ? tip.scattered_throughput() : tip.throughput) * sample.weight;
    if (!filter.accept(tip.throughput, point.material) || is_black(tip.throughput)) return false;
    if (!filter.accept_density(sample.pdf, point.material) ||
        !filter.accept_direction(sample.wi, point.material)) {
        return false;
    }
    if (!sample.straight) {
        if (scatters) {
            tip.caustic_share = bounce_share(sample.pdf, draw.photons.caustics);
            tip.indirect_share = bounce_share(sample.pdf, draw.photons.indirect);
        }
        tip.from_specular = sample.lobe == kSpecular;
        tip.counts_in_full = tip.from_specular || !in.settings.direct_light_sampling;
        tip.bounce_pdf = draw.choice_pdf * sample.pdf;
        if (!tip.counts_in_full) {
            tip.last_vertex = point;
            tip.last_vertex.bsdf = nullptr;
        }
        ++tip.scatterings;
        tip.seen_by.add(sample.lobe == kSpecular);
    }
    tip.ray = continue_ray(in.scene, point, sample.wi, sample.component, tip.ray);
    return true;
}

bool pass_straight(const EyePassInput& in, const SurfacePoint& point, Vec3 wo,
                   const VertexNumbers& numbers, InvalidSampleFilter& filter, PathTip& tip) {
    return !tip.counts_in_full && go_straight(in, point, wo, numbers, filter, tip);
}

bool go_straight(const EyePassInput& in, const SurfacePoint& point, Vec3 wo,
                 const VertexNumbers& numbers, InvalidSampleFilter& filter, PathTip& tip) {
    if (!(point.bsdf->lobes() & kSpecular)) return false;
    const std::uint32_t scatterings = tip.scatterings;
    const BounceDraw draw{kSpecular, 1, numbers.direction(), numbers.lobe()};
    return bounce(in, point, wo, draw, filter, tip) && tip.scatterings == scatterings;
}

VisiblePoint visible_point(const SurfacePoint& point, Vec3 wo, LobeMask receiving,
                           const Rgb& throughput, const EyeScatterings& seen_by) {
    VisiblePoint v;
    v.position = point.position;
    v.geometric_normal = point.geometric_normal;
    v.shading_normal = point.shading_normal;
    v.wo = wo;
    v.throughput = throughput;
    v.receiving = receiving;
    v.material = point.material;
    v.scatterings = seen_by;
    v.bsdf = point.bsdf->lambertian(v.kd) ? nullptr : point.bsdf;
    return v;
}

float emission_weight(const EyePassInput& in, const PathTip& tip, LightIndex light,
                      const SurfacePoint* at) {
    if (tip.scatterings == 0 && in.scene.lights()[light]->hidden_from_camera()) return 0;
    if (tip.counts_in_full) return tip.caustic_share;
    const float pdf_light = in.direct_light.pdf(light, tip.last_vertex, tip.ray.direction, at);
    // No density: what it weighs is refused, and counted against the light.
    if (!(pdf_light >= 0)) return std::numeric_limits<float>::quiet_NaN();
    if (tip.bounce_pdf == 0) return 0;
    return tip.bounce_pdf / (tip.bounce_pdf + pdf_light);
}

}  // namespace aips
