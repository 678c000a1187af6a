// LuxRender's camera and film as the engine sees them.
#include "film_shim.h"

#include <cmath>

#include "convert.h"

namespace aips::luxrender {

CameraRay CameraShim::generate(const CameraSample& sample, float time) const {
    const float lens[2] = {sample.lens.x, sample.lens.y};
    const auto at = [&](float x, float y) {
        const float film[2] = {sample.film.x + x, sample.film.y + y};
        return view_.camera_ray(film, lens, time);
    };
    const ViewRay here = at(0, 0);
    CameraRay ray;
    ray.ray = ray_of(here);
    const ViewRay right = at(1, 0), below = at(0, 1);
    const auto size = [](const Triple& a, const Triple& b, const Triple& c) {
        const Vec3 u = vector_of(b) - vector_of(a), v = vector_of(c) - vector_of(a);
        return 0.5f * std::sqrt(length(cross(u, v)));
    };
    ray.width = size(here.origin, right.origin, below.origin);
    ray.spread = size(here.direction, right.direction, below.direction);
    return ray;
}

void FilmShim::add_pass(const FilmPass& pass) {
    const auto add = [&](FilmPart part, std::span<const Vec2> positions,
                         std::span<const Rgb> radiance, double weight) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const float at[2] = {positions[i].x, positions[i].y};
            for (std::uint32_t g = 0; g < pass.groups; ++g)
                view_.add_sample(part, at, to(radiance[i * pass.groups + g]), g, weight);
        }
    };
    add(FilmPart::Eye, pass.positions, pass.eye, 1);
    if (!pass.photons.empty())
        add(FilmPart::Photons, pass.positions, pass.photons, pass.photon_weight);
    if (pass.splats) add(FilmPart::Splats, pass.splats->positions, pass.splats->radiance, 1);
    view_.end_film_pass();
}

}  // namespace aips::luxrender
