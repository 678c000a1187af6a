// How many photons go on from where one has landed: roulette and splitting.
#pragma once

#include "photons/photon_state.h"
#include "photons/scatter_photon.h"

namespace aips {

/// By the power that is expected to leave, against the power at emission, so that photons keep
/// about equal power; before its limits.
inline float plain_survival(const SurfacePoint& point, const PhotonState& photon) {
    const Rgb albedo = point.bsdf->albedo(-photon.ray.direction, kAllLobes);
    const float survival = max_component(photon.power * albedo) / photon.emitted_power;
    // Only steers: where the albedo is no number, what the surface scatters is what shows it.
    return survival >= 0 ? survival : 1;
}

/// Fixed before the direction is drawn. `logged`: the path is learned from, and wants to know of
/// all ways to decide; `split`: more than one photon may go on.
inline Survival decide_survival(const PhotonInput& in, const SurfacePoint& point,
                                const PhotonState& photon, bool logged, bool split) {
    Survival s;
    s.plain = plain_survival(point, photon);
    const bool by_score = in.score_mix != ScoreMix::None;
    if (in.survival && (logged || by_score)) {
        s.scored = in.survival
                       ->probability(point.position, normal_towards(-photon.ray.direction, point),
                                     luminance(photon.power))
                       .value_or(-1.0f);
    }
    // Specular lobes offer few ways: parts that take the same one fall on one point, so that
    // splitting there costs rays and leaves the noise.
    if (!(point.bsdf->lobes() & kNonSpecular)) s.most = 1;
    s.photons = photons_going_on(s, in.score_mix, 1);
    if (!split) s.photons = std::min(s.photons, 1.0f);
    return s;
}

}  // namespace aips
