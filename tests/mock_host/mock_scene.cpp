// The mock host's scene.
#include "mock_scene.h"

#include <algorithm>

#include "aips/core/sampling/sampling.h"
#include "mock_lights.h"

namespace mock {
namespace {

using aips::Vec3;

aips::LobeMask lobes_of(Material::Kind kind) {
    switch (kind) {
        case Material::Kind::Lambert:
            return aips::kDiffuse;
        case Material::Kind::Phong:
            return aips::kGlossy;
        case Material::Kind::LambertAndMirror:
            return aips::kDiffuse | aips::kSpecular;
        case Material::Kind::Sheet:
            return aips::kAllLobes;
        case Material::Kind::Mirror:
        case Material::Kind::Glass:
        case Material::Kind::Null:
            return aips::kSpecular;
    }
    return aips::kAllLobes;
}

}  // namespace

void Scene::add_point_light(Vec3 position, aips::Rgb intensity) {
    lights_.push_back(make_point_light(position, intensity));
}

void Scene::add_distant_light(const DistantCone& cone, aips::Rgb radiance) {
    aips::Bounds bounds;
    for (const Surface& s : surfaces_) {
        extend(bounds, s.shape);
    }
    lights_.push_back(make_distant_light(bounds, cone, radiance));
}

void Scene::add_box(Vec3 lo, Vec3 hi, const Surface& wall) {
    const Vec3 e = hi - lo, x{e.x, 0, 0}, y{0, e.y, 0}, z{0, 0, e.z};
    for (const Quad& quad : {Quad{lo, x, y}, Quad{lo, y, z}, Quad{lo, z, x}, Quad{hi, -y, -x},
                             Quad{hi, -z, -y}, Quad{hi, -x, -z}}) {
        Surface s = wall;
        s.shape = quad;
        add(s);
    }
}

void Scene::fill(const Fog& fog) {
    fog_ = fog;
    media_ = std::make_unique<Media>(*this, fog);
}

float Scene::distance_to_end(const aips::Ray& ray) const {
    const Vec3 to_center = (bounds_.lower + bounds_.upper) * 0.5f - ray.origin;
    const float approach = dot(to_center, ray.direction), radius = 0.5f * bounds_.diagonal();
    const float beside = length_squared(to_center) - approach * approach;
    return std::max(0.0f, approach + std::sqrt(std::max(0.0f, radius * radius - beside)));
}

void Scene::finish() {
    // Of an earlier call.
    std::erase_if(lights_, [&](const auto& light) {
        return std::ranges::find(lights_of_surfaces_, light.get()) != lights_of_surfaces_.end();
    });
    lights_of_surfaces_.clear();
    light_pointers_.clear();
    names_.clear();
    targets_.clear();
    light_of_surface_.assign(surfaces_.size(), aips::kNoLight);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Surface& s = surfaces_[i];
        names_.push_back("surface " + std::to_string(i));
        extend(bounds_, s.shape);
        targets_.add(s.shape);
        if (is_black(s.emitted)) continue;
        light_of_surface_[i] = static_cast<aips::LightIndex>(lights_.size());
        if (const Quad* quad = std::get_if<Quad>(&s.shape)) {
            lights_.push_back(make_quad_light(*quad, s.emitted, s.light_group));
        } else {
            lights_.push_back(make_ball_light(std::get<Ball>(s.shape), s.emitted, s.light_group));
        }
        lights_of_surfaces_.push_back(lights_.back().get());
    }
    for (const auto& light : lights_)
        light_pointers_.push_back(light.get());
    const Vec3 reach = max(abs(bounds_.lower), abs(bounds_.upper));
    const double farthest = std::max({reach.x, reach.y, reach.z});
    smallest_step_ = std::max(1e-5 * double(bounds_.diagonal()), 4 * 0x1p-23 * farthest);
}

bool Scene::nearest(const aips::Ray& ray, double t_max, RayTargets::Hit& hit) const {
    if (on_ray) on_ray(ray.time);
    return targets_.nearest(ray, smallest_step_, t_max, hit);
}

bool Scene::intersect(const aips::Ray& ray, aips::SurfacePoint& point,
                      std::pmr::memory_resource& memory) const {
    RayTargets::Hit hit;
    if (!nearest(ray, std::numeric_limits<double>::infinity(), hit)) {
        if (!media_) return false;
        point.distance = distance_to_end(ray);
        point.transmittance = fog_.transmittance(point.distance);
        return false;
    }
    const Surface& surface = surfaces_[hit.shape];
    point.distance = static_cast<float>(hit.t);
    if (media_) point.transmittance = fog_.transmittance(point.distance);
    point.position = ray.origin + ray.direction * point.distance;
    point.geometric_normal = front_normal(surface.shape, point.position);
    point.shading_normal = surface.normal_tilt == Vec3{}
                               ? point.geometric_normal
                               : normalize(point.geometric_normal + surface.normal_tilt);
    const bool front = dot(ray.direction, point.geometric_normal) < 0;
    point.light = front ? light_of_surface_[hit.shape] : aips::kNoLight;
    point.emitted = front ? surface.emitted : aips::Rgb{};
    point.material = static_cast<std::uint32_t>(hit.shape);
    point.bsdf = make_bsdf(surface.material, point.geometric_normal, point.shading_normal, memory);
    return true;
}

aips::Ray Scene::spawn(const aips::SurfacePoint& point, Vec3 direction, float time) const {
    return {point.position, direction, time, nullptr};
}

aips::Rgb Scene::visibility(const aips::SurfacePoint& point, const aips::DirectSample& light,
                            float time) const {
    return visibility_from(point.position, light, time);
}

aips::Rgb Scene::visibility_from(Vec3 position, const aips::DirectSample& light, float time) const {
    const aips::Ray ray{position, light.wi, time, nullptr};
    double from = 0;
    const double end = double(light.distance) - smallest_step_;
    for (int passed = 0; passed < 64; ++passed) {
        aips::Ray rest = ray;
        rest.origin = ray.origin + ray.direction * static_cast<float>(from);
        RayTargets::Hit hit;
        if (!nearest(rest, end - from, hit)) {
            if (!media_) return aips::kWhite;
            return fog_.transmittance(std::isfinite(light.distance) ? light.distance
                                                                    : distance_to_end(ray));
        }
        if (surfaces_[hit.shape].material.kind != Material::Kind::Null) return {};
        from += hit.t;
    }
    return {};
}

aips::SceneFacts Scene::facts() const {
    aips::SceneFacts facts;
    facts.lobes = 0;
    for (const Surface& s : surfaces_)
        facts.lobes |= lobes_of(s.material.kind);
    facts.has_media = media_ != nullptr;
    facts.max_bsdf_bytes = max_bsdf_bytes();
    return facts;
}

}  // namespace mock
