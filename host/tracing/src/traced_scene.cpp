// Builds the traced scene and answers its queries.
#include "traced_scene.h"

#include <cmath>
#include <tuple>

#include "area_lights.h"
#include "lxs/tracing/trace_scene.h"
#include "precision_warning.h"
#include "scene_sphere.h"
#include "surface_point.h"

namespace lxs {
namespace {

TimeSpan times_of(const std::vector<Instance>& instances) {
    TimeSpan times;
    for (const Instance& instance : instances) {
        for (const MotionKey& key : instance.motion) {
            times.begin = std::min(times.begin, key.time);
            times.end = std::max(times.end, key.time);
        }
    }
    return times;
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
    : contents_(std::move(contents)),
      refused_(std::make_unique<RefusedValues[]>(contents_.material_names.size() + 1)),
      media_(contents_),
      survey_(survey(contents_, diagnostics)),
      world_scene_(device_),
      spectral_media_(contents_.media),
      spectral_need_(lxs::spectral_need(survey_.spectra)) {
    build_geometry();
    place_instances();
    warn_of_lost_precision(bounds_, contents_.end, diagnostics);
    make_area_lights(diagnostics);
    find_boundaries();
    // Placements have what is still needed of instances: room for the hierarchy.
    std::vector<Instance>().swap(contents_.instances);
    world_scene_.commit();
    make_other_lights(resolve, diagnostics);
    bound_media();
    for (const auto& light : lights_)
        light_pointers_.push_back(light.get());
    if (media_.empty()) return;
    find_camera_media(diagnostics);
    find_light_media(diagnostics);
    warn_of_media(diagnostics);
}

void TracedScene::build_geometry() {
    const bool tabulates_planes = survey_.facts.triangles <= kMostTabulatedPlanes;
    world_surfaces_ =
        make_surface_group(contents_.primitives, "", object_names_, media_, tabulates_planes);
    add_surfaces(world_scene_, world_surfaces_, contents_.primitives);
    bounds_ = world_surfaces_.bounds;
    for (ObjectDefinition& object : contents_.objects) {
        object_surfaces_.push_back(make_surface_group(object.primitives, object.name, object_names_,
                                                      media_, tabulates_planes));
        EmbreeScene& scene = object_scenes_.emplace_back(device_);
        add_surfaces(scene, object_surfaces_.back(), object.primitives);
        scene.commit();
    }
}

void TracedScene::place_instances() {
    placements_.reserve(contents_.instances.size() + 1);
    placements_.emplace_back().surfaces = world_surfaces_.surfaces.data();
    std::uint32_t light_count = world_surfaces_.emissive_count;
    transforms_.reserve(contents_.instances.size());  // placements point into both
    moving_.reserve(contents_.instances.size());
    const TimeSpan times = times_of(contents_.instances);
    if (times.end > times.begin) world_scene_.set_times(times.begin, times.end);
    for (const Instance& instance : contents_.instances) {
        check_invertible(instance, contents_.objects[instance.object]);
        const SurfaceGroup& group = object_surfaces_[instance.object];
        const auto id =
            static_cast<std::uint32_t>(contents_.primitives.size() + placements_.size() - 1);
        Placement& placement = placements_.emplace_back();
        placement.surfaces = group.surfaces.data();
        placement.world_to_object = instance.to_world.inverse();
        placement.first_light = light_count;
        light_count += group.emissive_count;
        if (instance.outer != Instance::kNoOuterObject)
            placement.object = object_names_.index_of(contents_.outer_objects[instance.outer]);
        if (!instance.motion.empty()) {
            place_moving(instance, id, times, placement);
            continue;
        }
        world_scene_.add_instance(id, object_scenes_[instance.object], instance.to_world);
        placement.transform = &transforms_.emplace_back(instance.to_world);
        bounds_.extendBy(transformed(group.bounds, instance.to_world));
    }
}

void TracedScene::place_moving(const Instance& instance, std::uint32_t id, const TimeSpan& times,
                               Placement& placement) {
    std::vector<Matrix> steps = MotionPath(instance.motion).steps(times.begin, times.end);
    world_scene_.add_instance(id, object_scenes_[instance.object], steps);
    // Between steps each point goes straight: the boxes at the steps hold the boxes between.
    for (const Matrix& step : steps)
        bounds_.extendBy(transformed(object_surfaces_[instance.object].bounds, step));
    placement.moving = &moving_.emplace_back(std::move(steps), times.begin, times.end);
}

void TracedScene::make_area_lights(Diagnostics& diagnostics) {
    const auto append_area = [&](const std::vector<Primitive>& primitives, const Matrix& placed) {
        append_area_lights(primitives, placed, lights_, area_lights_, diagnostics);
        for (const Primitive& primitive : primitives) {
            if (!primitive.emission) continue;
            light_places_.push_back(primitive.emission->where);
            declared_media_.push_back(media_.number_of(primitive.exterior.get()));
        }
    };
    append_area(contents_.primitives, Matrix());
    for (const Instance& instance : contents_.instances)
        append_area(contents_.objects[instance.object].primitives, instance.to_world);
    sphere_ = unbounded_media_end(contents_, bounds_);
}

void TracedScene::make_other_lights(const AssetResolver& resolve, Diagnostics& diagnostics) {
    for (const LightDescription& description : contents_.lights) {
        const MediumNumber declared = media_.number_of(description.medium.get());
        try {
            for (auto& light : make_lights(description, sphere_, resolve, diagnostics))
                lights_.push_back(std::move(light));
            light_places_.resize(lights_.size(), description.parameters.where);
            declared_media_.resize(lights_.size(), declared);
        } catch (const InputError& error) {
            diagnostics.fallback(error.where(), error.message(), "the light is left out");
        }
    }
}

void TracedScene::set_wavelengths(const Wavelengths& wavelengths) {
    const bool first = !wavelengths_;
    wavelengths_ = wavelengths;
    spectral_media_.set_wavelengths(*wavelengths_);  // which media that vary ask during the pass
    if (first) make_spectral_lights();
    spectral_lamps_.set_wavelengths(wavelengths);
}

/// Area lights come first among the lights, in the order of their table.
void TracedScene::make_spectral_lights() {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Rgb* const unit =
            i < area_lights_.size() ? spectral_lamps_.add(area_lights_[i]->spectrum()) : nullptr;
        spectral_lights_.push_back(
            std::make_unique<SpectralLight>(*lights_[i], *wavelengths_, unit));
        light_pointers_[i] = spectral_lights_.back().get();
    }
}

WavelengthDensity TracedScene::wavelength_density() const {
    constexpr double kBesideOthers = 0.5, kAlone = 0.9;
    const bool others = survey_.spectra.has_plain_lamps;
    return {survey_.spectra.lamps, others ? kBesideOthers : kAlone};
}

const TracedScene::Placement& TracedScene::placement_of(const RawHit& raw) const {
    return placements_[raw.instance == kNoInstance
                           ? 0
                           : raw.instance - world_surfaces_.surfaces.size() + 1];
}

const Surface& TracedScene::locate_hit(const Ray& ray, RawHit raw, SurfaceHit& hit,
                                       ShadingPoint& point) const {
    const Placement& placement = placement_of(raw);
    const Surface& surface = placement.surfaces[raw.geometry];
    std::optional<InstanceTransform> moved;
    if (placement.moving) moved.emplace(placement.moving->at(ray.time));
    const InstanceTransform* const transform = moved ? &*moved : placement.transform;
    locate(surface, transform, ray, raw, hit);
    const bool behind = ray.direction.dot(hit.ng) > 0;
    const MediumNumber near = behind ? surface.interior : surface.exterior;
    const MediumNumber far = behind ? surface.exterior : surface.interior;
    // A lamp stands in what other surfaces bound: shadow rays, which end before it, go by that.
    const bool tells = surface.emissive_index == Surface::kNotEmissive;
    hit.crossed = tells ? ray.media.up_to(near) : ray.media;
    (behind ? hit.interior : hit.exterior) = tells ? ray.media.back_from(near) : ray.media.known();
    (behind ? hit.exterior : hit.interior) = ray.media.beyond(near, far);
    if (!surface.material) return surface;
    point.texture.p = hit.p;
    point.texture.n = hit.ns;
    point.texture.uv = hit.uv;
    point.texture.wavelengths = wavelengths_ ? &*wavelengths_ : nullptr;
    point.texture.refused = &refused_[surface.material_index];
    constexpr std::uint32_t kFacesApart = 0x9E3779B1;  // odd: no two shapes share all their faces
    point.texture.face = raw.geometry * kFacesApart + raw.primitive;
    point.texture.world_to_object = placement.to_object();
    point.texture.object_to_shape = &surface.object_to_shape;
    add_vertex_values(surface, raw, point.texture);
    point.ng = hit.ng;
    point.ns = hit.ns;
    point.dpdu = hit.dpdu;
    if (surface.reads_dpdv) point.dpdv = tangent_along_v(surface, transform, raw, hit);
    // What is declared decides on the index, as in LuxRender, even if the ray is in another medium.
    const auto on_side = [&](MediumNumber declared, const EnteredMedia& entered) {
        return media_.medium(declared != kNoMedium ? declared : entered.innermost());
    };
    point.interior = on_side(surface.interior, hit.interior);
    point.exterior = on_side(surface.exterior, hit.exterior);
    point.component = ray.component;
    return surface;
}

bool TracedScene::find(const Ray& ray, RawHit& raw, SurfaceHit& hit) const {
    if (!world_scene_.intersect(ray, kSmallestDistance, SurfaceClass::Any, raw)) {
        hit.crossed = ray.media;
        if (!medium(ray.media)) return false;
        hit.distance = std::min(ray.t_max, distance_to_end(sphere_, ray));
        add_crossed(ray, hit);
        return false;
    }
    hit.distance = raw.distance;
    return true;
}

void TracedScene::add_crossed(const Ray& ray, SurfaceHit& hit) const {
    const Medium* const crossed = medium(hit.crossed);
    hit.transmittance =
        crossed ? crossed->transmittance(ray.origin, ray.direction, hit.distance) : Rgb(1.0f);
    if (!crossed || !crossed->emits()) return;
    const std::size_t light = medium_lights_[hit.crossed.innermost()];
    if (light == kNoMediumLight) return;
    hit.medium_light = light_pointers_[light];
    hit.medium_emitted = crossed->emitted(ray.origin, ray.direction, hit.distance);
}

bool TracedScene::intersect_specular(const Ray& ray, SurfaceHit& hit,
                                     std::pmr::memory_resource& memory) const {
    RawHit raw;
    if (!find(ray, raw, hit)) return false;
    const Surface& surface = placement_of(raw).surfaces[raw.geometry];
    if (surface.may_be_specular || surface.emissive_index != Surface::kNotEmissive)
        return complete(ray, raw, hit, memory);
    hit.bsdf = nullptr;
    hit.light = nullptr;
    hit.crossed = ray.media;
    if (ray.media.known() == EnteredMedia() && surface.declares_medium()) {
        ShadingPoint point;
        locate_hit(ray, raw, hit, point);
    }
    add_crossed(ray, hit);
    return true;
}

bool TracedScene::intersect_shape(const Ray& ray, SurfaceHit& hit,
                                  std::pmr::memory_resource& /*memory*/) const {
    RawHit raw;
    if (!find(ray, raw, hit)) return false;
    ShadingPoint point;
    locate_hit(ray, raw, hit, point);
    return true;
}

bool TracedScene::complete(const Ray& ray, const RawHit& raw, SurfaceHit& hit,
                           std::pmr::memory_resource& memory) const {
    ShadingPoint point;
    const Surface& surface = locate_hit(ray, raw, hit, point);
    add_crossed(ray, hit);
    hit.primitive = raw.primitive;
    hit.material = surface.material_index;
    const std::uint32_t outer = placement_of(raw).object;
    hit.object = outer != Placement::kOwnObjects ? outer : surface.object_index;
    hit.light = nullptr;
    hit.emitted = Rgb(0.0f);
    if (surface.emissive_index != Surface::kNotEmissive) {
        // Area lights come first among the lights, in the order of their table.
        const std::size_t light =
            std::size_t{placement_of(raw).first_light} + surface.emissive_index;
        const Vec3 wo = -ray.direction;
        hit.light = light_pointers_[light];
        if (wo.dot(hit.ng) > 0) {
            hit.emitted = area_lights_[light]->radiance(hit.p, hit.ng, hit.uv, wo);
            if (wavelengths_) hit.emitted = spectral_lights_[light]->at_wavelengths(hit.emitted);
        }
    }
    hit.bsdf = nullptr;
    if (!surface.material) return true;
    if (surface.bends) {
        surface.material->bend(point);
        hit.ns = point.ns;
    }
    hit.bsdf = surface.material->scatter(point, memory);
    return true;
}

InvalidSampleList TracedScene::refused_values() const {
    InvalidSampleList list;
    const auto add = [&](const std::string& user, const RefusedValues& refused) {
        for (const auto& [texture, count] : refused.totals()) {
            list.push_back(
                {texture.empty() ? user : "texture " + in_quotes(texture) + " of " + user, count});
        }
    };
    for (std::size_t i = 0; i < contents_.material_names.size(); ++i)
        add("material " + in_quotes(contents_.material_names[i]), refused_[i]);
    for (std::size_t i = 0; i < area_lights_.size(); ++i)
        add("light " + std::to_string(i) + " (area)", area_lights_[i]->refused_values());
    return list;
}

void TracedScene::state(StateArchive& archive) {
    const auto refused_state = [&](RefusedValues& refused) {
        const RefusedValues::Totals known = refused.totals();
        RefusedValues::Totals totals;
        auto next = known.begin();
        const std::size_t count = archive.count(known.size(), sizeof(std::uint64_t));
        for (std::size_t i = 0; i < count; ++i) {
            std::string texture;
            std::uint64_t total = 0;
            if (!archive.restoring()) std::tie(texture, total) = *next++;
            archive.text(texture);
            archive.value(total);
            totals[texture] = total;
        }
        refused.set_totals(totals);
    };
    for (std::size_t i = 0; i < contents_.material_names.size(); ++i)
        refused_state(refused_[i]);
    for (const auto& light : area_lights_)
        refused_state(light->refused_values());
}

std::unique_ptr<TraceScene> make_trace_scene(SceneContents contents, const AssetResolver& resolve,
                                             Diagnostics& diagnostics) {
    return std::make_unique<TracedScene>(std::move(contents), resolve, diagnostics);
}

}  // namespace lxs
