// Chains of specular surfaces.
#include "emitter_paths/specular_chain.h"

#include <algorithm>

#include "eye/path_tip.h"
#include "sample_filter/meet_surface.h"

namespace aips {

/// At most `most` surfaces, of which `way` is told number, material and the probability of the
/// first of two ways, and tells whether to take that, or to stop. Returns how many there were.
template <class Way>
unsigned ChainTracer::trace(Vec2 film, unsigned most, ChainVertices& vertices, const Way& way) {
    const CameraRay camera_ray = in_.camera.generate({film, {0.5f, 0.5f}}, time_);
    PathTip tip;
    tip.ray = camera_ray.ray;
    const auto mark = arena_.mark();
    unsigned length = 0;
    while (length < most) {
        arena_.rewind(mark);
        SurfacePoint point;
        ++rays_;
        if (!meet_surface(in_.scene, tip.ray, point, arena_, filter_, Sought::Specular)) break;
        if (!point.bsdf || point.bsdf->lobes() != kSpecular) break;
        const Vec3 wo = -tip.ray.direction;
        const float first = point.bsdf->first_specular(wo);
        const bool choice = first > 0 && first < 1;
        bool takes_first = true;
        if (!way(length, point.material, choice ? first : 0, takes_first)) break;
        const float u_lobe = !choice ? 0.5f : takes_first ? 0.5f * first : 0.5f * (1 + first);
        if (!bounce(in_, point, wo, {kSpecular, 1, {0.5f, 0.5f}, u_lobe}, filter_, tip)) break;
        point.bsdf = nullptr;
        vertices[length++] = {point, tip.ray.direction, choice ? first : 0};
    }
    arena_.rewind(mark);
    return length;
}

SpecularChain ChainTracer::explore(Vec2 film, RandomStream& random, ChainVertices& vertices) {
    SpecularChain chain;
    const DepthLimit limit = eye_depth(in_.settings);
    const unsigned most = std::min(SpecularChain::kMost, limit.surfaces + limit.specular - 1);
    chain.length = trace(film, most, vertices,
                         [&](unsigned i, std::uint32_t material, float first, bool& takes_first) {
                             // Nearly by chance: seldom ways show emitters as well.
                             takes_first = random.next() < std::clamp(first, 0.25f, 0.75f);
                             chain.links[i] = {material, first, takes_first};
                             return true;
                         });
    return chain;
}

unsigned ChainTracer::follow(SpecularChain& chain, unsigned length, Vec2 film,
                             ChainVertices& vertices) {
    return trace(film, length, vertices,
                 [&](unsigned i, std::uint32_t material, float first, bool& takes_first) {
                     SpecularChain::Link& link = chain.links[i];
                     takes_first = link.takes_first;
                     if (link.material != material || (link.first > 0) != (first > 0)) return false;
                     link.first = first;
                     return true;
                 });
}

void ChainTracer::recall(SpecularChain& chain, unsigned length, const ChainVertices& vertices) {
    for (unsigned i = 0; i < length; ++i)
        chain.links[i].first = vertices[i].first;
    rays_ += length;
}

}  // namespace aips
