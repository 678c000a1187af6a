// The tip of an eye path: what its next surface has to know of the last.
#pragma once

#include <algorithm>

#include "aips/core/base/image_part.h"
#include "aips/core/photon_map/photon.h"
#include "eye/constants.h"
#include "eye/eye_pass.h"

namespace aips {

struct PathTip {
    Ray ray;
    Rgb throughput = kWhite;  ///< of emitters that its ray meets
    /// What photons on the glossy lobe that sent it on leave of emitters that it meets by way of
    /// specular surfaces, and of light that the next lobe which is not specular scatters.
    float caustic_share = 1, indirect_share = 1;
    bool from_specular = true;      ///< it leaves the camera or a specular lobe
    bool counts_in_full = true;     ///< likewise, or no shadow rays are sent: lights count in full
    float bounce_pdf = 0;           ///< of the last scattering that was not straight
    SurfacePoint last_vertex;       ///< where that was; kept only if it was not specular
    std::uint32_t scatterings = 0;  ///< that were not straight
    EyeScatterings seen_by;         ///< the same, by kind

    /// Of light that a lobe which is not specular scatters into the ray.
    Rgb scattered_throughput() const { return throughput * indirect_share; }
};

/// A direction to be drawn from the lobes in `mask`, which are chosen with probability
/// `choice_pdf`.
struct BounceDraw {
    LobeMask mask = 0;
    float choice_pdf = 1;
    Vec2 u;
    float u_lobe = 0;
    GlossDensities photons = {};  ///< that bring light to glossy lobes beside it
};

/// Sends the path on from `point`, where it arrived from `wo`; false if it ends there.
bool bounce(const EyePassInput& input, const SurfacePoint& point, Vec3 wo, const BounceDraw& draw,
            InvalidSampleFilter& filter, PathTip& tip);

/// Surfaces that a ray passes straight, at most, to bring what a shadow ray has left to it: as many
/// as shadow rays of the host pass.
inline constexpr std::uint32_t kMostStraightSurfaces = 256;

/// Whether an eye path meets surface number `depth` of those that count: beyond the last of them a
/// ray that flies straight on still brings what the shadow ray of a glossy lobe has left to it.
inline bool may_meet(const Settings& settings, const PathTip& tip, std::uint32_t depth) {
    const std::uint32_t most = eye_depth(settings).surfaces;
    return depth <= most || (!tip.counts_in_full && depth - most < kMostStraightSurfaces);
}

/// At the last surface that counts, or beyond: the way straight on, for a ray that owes light to
/// the shadow ray of its last surface; false if it ends there.
bool pass_straight(const EyePassInput& input, const SurfacePoint& point, Vec3 wo,
                   const VertexNumbers& numbers, InvalidSampleFilter& filter, PathTip& tip);

/// Whether the path has had all its bounces: then it may go straight on, no more.
inline bool is_spent(const Settings& settings, const PathTip& tip) {
    return tip.scatterings >= settings.max_bounces;
}

/// The way straight on for a path that is spent; false if it ends there.
bool go_straight(const EyePassInput& input, const SurfacePoint& point, Vec3 wo,
                 const VertexNumbers& numbers, InvalidSampleFilter& filter, PathTip& tip);

/// Where a path ends: lobes `receiving` of `point` take photons, seen from `wo`. The rest of it is
/// the eye path's to fill in.
VisiblePoint visible_point(const SurfacePoint& point, Vec3 wo, LobeMask receiving,
                           const Rgb& throughput, const EyeScatterings& seen_by);

/// Most bounces of photons that may join the path where it is, by one scattering more.
inline std::uint16_t photon_bounces(const Settings& settings, const PathTip& tip) {
    if (is_spent(settings, tip)) return 0;
    return std::uint16_t(std::min(settings.max_bounces - tip.scatterings - 1, kMostPhotonBounces));
}

/// Share of the light met by the path's ray, at `at` or at infinity, that shadow rays from the last
/// vertex leave to it; nothing of a light that is hidden from the camera before the path has
/// scattered. NaN where the light has no density.
float emission_weight(const EyePassInput& input, const PathTip& tip, LightIndex light,
                      const SurfacePoint* at);

/// Calls `add(light, radiance)` for each light at infinity that the path's ray sees.
template <class Add>
void for_each_escaped(const EyePassInput& input, const PathTip& tip, InvalidSampleFilter& filter,
                      const Add& add) {
    const auto lights = input.scene.lights();
    for (const LightIndex i : input.direct_light.at_infinity()) {
        const Rgb seen = lights[i]->escaped(tip.ray.direction);
        if (is_black(seen) || !filter.accept(seen, filter.of_light(i))) continue;
        add(i, seen);
    }
}

}  // namespace aips
