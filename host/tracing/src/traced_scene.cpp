// Builds the traced scene and answers its queries.
#include "traced_scene.h"

#include <cmath>

#include "area_lights.h"
#include "lxs/tracing/trace_scene.h"
#include "surface_point.h"

namespace lxs {
namespace {

SceneSphere enclosing_sphere(const Bounds& box) {
    if (box.isEmpty()) return {};
    constexpr float kRoundingMargin = 1.00001f;
    const float radius = (box.max - box.min).length() / 2 * kRoundingMargin;
    return {box.center(), radius > 0 ? radius : 1.0f};
}

ShadingPoint shading_point(const SurfaceHit& hit, const Surface& surface,
                           const Matrix* world_to_object, const RawHit& raw) {
    constexpr std::uint32_t kFacesApart = 0x9E3779B1;  // odd: no two shapes share all their faces
    ShadingPoint point;
    point.texture = {hit.p, hit.ns, hit.uv};
    point.texture.face = raw.geometry * kFacesApart + raw.primitive;
    point.texture.world_to_object = world_to_object;
    point.texture.object_to_shape = &surface.object_to_shape;
    point.ng = hit.ng;
    point.ns = hit.ns;
    point.dpdu = hit.dpdu;
    point.interior = hit.interior;
    point.exterior = hit.exterior;
    return point;
}

Rgb medium_transmittance(const Medium* medium, float distance) {
    if (!medium) return Rgb(1.0f);
    // A finite distance keeps a channel that isn't absorbed free of zero times infinity.
    return medium->transmittance(std::min(distance, std::numeric_limits<float>::max()));
}

void check_invertible(const Instance& instance, const ObjectDefinition& object) {
    const double determinant = instance.to_world.determinant();
    if (std::isfinite(determinant) && determinant != 0) return;
    const SourceLocation where =
        object.primitives.empty() ? SourceLocation{} : object.primitives.front().where;
    throw InputError(where, "an instance of object \"" + object.name +
                                "\" has a transform that can't be inverted");
}

}  // namespace

TracedScene::TracedScene(SceneContents contents, const AssetResolver& resolve,
                         Diagnostics& diagnostics)
    : contents_(std::move(contents)), survey_(survey(contents_)), world_scene_(device_) {
    build_geometry();
    place_instances();
    world_scene_.commit();
    make_all_lights(resolve, diagnostics);
}

void TracedScene::build_geometry() {
    world_surfaces_ = make_surface_group(contents_.primitives);
    add_surfaces(world_scene_, world_surfaces_, contents_.primitives);
    bounds_ = world_surfaces_.bounds;
    for (ObjectDefinition& object : contents_.objects) {
        object_surfaces_.push_back(make_surface_group(object.primitives));
        EmbreeScene& scene = object_scenes_.emplace_back(device_);
        add_surfaces(scene, object_surfaces_.back(), object.primitives);
        scene.commit();
    }
}

void TracedScene::place_instances() {
    placements_.push_back({world_surfaces_.surfaces.data(), nullptr, {}, 0});
    std::size_t light_count = world_surfaces_.emissive_count;
    transforms_.reserve(contents_.instances.size());  // placements point into it
    for (const Instance& instance : contents_.instances) {
        check_invertible(instance, contents_.objects[instance.object]);
        const SurfaceGroup& group = object_surfaces_[instance.object];
        const auto id =
            static_cast<std::uint32_t>(contents_.primitives.size() + transforms_.size());
        world_scene_.add_instance(id, object_scenes_[instance.object], instance.to_world);
        placements_.push_back({group.surfaces.data(), &transforms_.emplace_back(instance.to_world),
                               instance.to_world.inverse(), light_count});
        light_count += group.emissive_count;
        bounds_.extendBy(transformed(group.bounds, instance.to_world));
    }
}

void TracedScene::make_all_lights(const AssetResolver& resolve, Diagnostics& diagnostics) {
    append_area_lights(contents_.primitives, Matrix(), lights_, area_lights_);
    for (const Instance& instance : contents_.instances) {
        append_area_lights(contents_.objects[instance.object].primitives, instance.to_world,
                           lights_, area_lights_);
    }
    const SceneSphere sphere = enclosing_sphere(bounds_);
    for (const LightDescription& description : contents_.lights) {
        for (auto& light : make_lights(description, sphere, resolve, diagnostics))
            lights_.push_back(std::move(light));
    }
    for (const auto& light : lights_)
        light_pointers_.push_back(light.get());
}

const TracedScene::Placement& TracedScene::placement_of(const RawHit& raw) const {
    return placements_[raw.instance == kNoInstance
                           ? 0
                           : raw.instance - world_surfaces_.surfaces.size() + 1];
}

bool TracedScene::intersect(const Ray& ray, SurfaceHit& hit,
                            std::pmr::memory_resource& memory) const {
    RawHit raw;
    if (!world_scene_.intersect(ray, kSmallestDistance, SurfaceClass::Any, raw)) return false;
    const Placement& placement = placement_of(raw);
    const Surface& surface = placement.surfaces[raw.geometry];
    locate(surface, placement.transform, ray, raw, hit);
    hit.interior = surface.interior;
    hit.exterior = surface.exterior;
    hit.primitive = raw.primitive;
    hit.material = surface.material_index;
    hit.transmittance = medium_transmittance(ray.medium, raw.distance);
    hit.light = nullptr;
    hit.emitted = Rgb(0.0f);
    if (surface.emissive_index != Surface::kNotEmissive) {
        const AreaLight* light = area_lights_[placement.first_light + surface.emissive_index];
        const Vec3 wo = -ray.direction;
        hit.light = light;
        if (wo.dot(hit.ng) > 0) hit.emitted = light->radiance(hit.p, hit.ng, hit.uv, wo);
    }
    hit.bsdf = surface.material
                   ? surface.material->scatter(
                         shading_point(hit, surface, placement.to_object(), raw), memory)
                   : nullptr;
    return true;
}

Rgb TracedScene::transmittance(const Ray& ray) const {
    if (survey_.has_straight) {
        const bool blocked =
            device_.distinguishes_classes() && world_scene_.occluded(ray, SurfaceClass::Opaque);
        return blocked ? Rgb(0.0f) : walk_transmittance(ray);
    }
    // Light that passes no surface stays in the ray's medium: any hit at all decides.
    if (world_scene_.occluded(ray, SurfaceClass::Any)) return Rgb(0.0f);
    return medium_transmittance(ray.medium, ray.t_max);
}

// Goes from surface to surface on the same ray, whose start moves past each hit by one rounding
// step: origin and direction stay, so the kernel computes the same distance for a surface that was
// passed and leaves it out, and the segment's end doesn't drift.
Rgb TracedScene::walk_transmittance(const Ray& ray) const {
    Rgb share(1.0f);
    const Medium* medium = ray.medium;
    float start = kSmallestDistance, passed = 0;
    for (int i = 0; i < kMaxStraightSurfaces; ++i) {
        RawHit raw;
        if (!world_scene_.intersect(ray, start, SurfaceClass::Straight, raw))
            return share * medium_transmittance(medium, ray.t_max - passed);
        const Placement& placement = placement_of(raw);
        const Surface& surface = placement.surfaces[raw.geometry];
        if (!surface.straight) return Rgb(0.0f);
        SurfaceHit hit;
        locate(surface, placement.transform, ray, raw, hit);
        hit.interior = surface.interior;
        hit.exterior = surface.exterior;
        share *= medium_transmittance(medium, raw.distance - passed) *
                 surface.material->straight_transmittance(
                     shading_point(hit, surface, placement.to_object(), raw), ray.direction);
        if (is_black(share)) return share;
        medium = ray.direction.dot(hit.ng) > 0 ? hit.exterior : hit.interior;
        passed = raw.distance;
        start = std::nextafter(raw.distance, std::numeric_limits<float>::infinity());
    }
    return Rgb(0.0f);
}

std::unique_ptr<Scene> make_trace_scene(SceneContents contents, const AssetResolver& resolve,
                                        Diagnostics& diagnostics) {
    return std::make_unique<TracedScene>(std::move(contents), resolve, diagnostics);
}

}  // namespace lxs
