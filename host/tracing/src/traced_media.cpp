// In which media the traced scene's camera and lights stand, and what is wrong with its media.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

#include "scene_sphere.h"
#include "traced_scene.h"

namespace lxs {
namespace {

constexpr int kPlaces = 4;                    ///< on each light
constexpr int kMostTries = 1024;              ///< where those found none
constexpr std::size_t kMostStarts = 9;        ///< of rays that look for faults
constexpr std::size_t kPointsOfMesh = 8;      ///< that these rays aim at
constexpr std::size_t kMostBoundaries = 512;  ///< such points in all

double radical_inverse(int base, int number) {
    double value = 0, digit = 1;
    for (; number > 0; number /= base) {
        digit /= base;
        value += digit * (number % base);
    }
    return value;
}

/// Where the light's photons start.
std::vector<Vec3> places_of(const Light& light) {
    std::vector<Vec3> places;
    for (int i = 0; i < kPlaces; ++i) {
        const double x = (i + 0.5) / kPlaces;
        EmissionSample sample;
        if (light.sample_emission({x, i % 2 == 0 ? 0.3 : 0.7, 0.5, 0.5}, sample))
            places.push_back(sample.ray.origin);
    }
    // A medium that shines may fill little of its box: Halton's points.
    for (int i = 1; places.empty() && i < kMostTries; ++i) {
        EmissionSample sample;
        const PrimaryPoint u{radical_inverse(2, i), radical_inverse(3, i), 0.5, 0.5};
        if (light.sample_emission(u, sample)) places.push_back(sample.ray.origin);
    }
    return places;
}

/// Some points of a surface that bounds media or is of glass.
void append_points(const Surface& surface, const Matrix& to_world, std::vector<Vec3>& points) {
    const auto append = [&](const Vec3& p) {
        Imath::V3d placed;
        to_world.multVecMatrix(Imath::V3d(p), placed);
        points.emplace_back(placed);
    };
    if (!surface.declares_medium() && !surface.index_of_media && !surface.own_index) return;
    if (surface.quadric) return append(surface.quadric->bounds().center());
    const auto& mesh = std::get<TriangleMesh>(surface.primitive->geometry);
    const std::size_t triangles = mesh.indices.size() / 3;
    for (std::size_t i = 0; i < std::min(triangles, kPointsOfMesh); ++i) {
        const std::uint32_t* const corner =
            mesh.indices.data() + 3 * (i * triangles / std::min(triangles, kPointsOfMesh));
        append((mesh.positions[corner[0]] + mesh.positions[corner[1]] + mesh.positions[corner[2]]) /
               3);
    }
}

/// A surface of the world.
Bounds bounds_of(const Surface& surface) {
    if (surface.quadric) return surface.quadric->bounds();
    Bounds bounds;
    for (const Vec3& p : std::get<TriangleMesh>(surface.primitive->geometry).positions)
        bounds.extendBy(p);
    return bounds;
}

}  // namespace

void TracedScene::bound_media() {
    const FieldJobs jobs = [](int count, const std::function<void(int)>& job) {
        tbb::parallel_for(0, count, job);
    };
    medium_lights_.assign(media_.size(), kNoMediumLight);
    for (const SceneMedium& medium : contents_.media) {
        const bool needs_bounds = medium.medium->varies() || medium.medium->emits();
        if (!needs_bounds || !media_.contains(medium.medium.get())) continue;
        const MediumExtent extent = extent_of(medium);
        if (extent.bounds.isEmpty()) continue;
        if (medium.medium->varies()) medium.medium->bound(extent.bounds, jobs);
        if (medium.medium->emits()) make_medium_light(medium, extent, jobs);
    }
}

TracedScene::MediumExtent TracedScene::extent_of(const SceneMedium& medium) const {
    const MediumNumber number = media_.number_of(medium.medium.get());
    MediumExtent extent;
    Bounds beside;  // around surfaces that it is outside of
    const auto add = [&](const Surface& surface, const Bounds& around) {
        if (surface.interior == number) extent.bounds.extendBy(around);
        if (surface.exterior == number) beside.extendBy(around);
    };
    for (const Surface& surface : world_surfaces_.surfaces)
        add(surface, bounds_of(surface));
    for (const SurfaceGroup& object : object_surfaces_) {
        for (const Surface& surface : object.surfaces)
            add(surface, bounds_);
    }
    // What lies within the medium's own surfaces does not tell that it goes on beyond them.
    extent.endless = contents_.camera_medium == medium.medium ||
                     (!beside.isEmpty() && !(extent.bounds.intersects(beside.min) &&
                                             extent.bounds.intersects(beside.max)));
    for (std::size_t i = 0; i < declared_media_.size(); ++i) {
        if (declared_media_[i] != number) continue;
        const std::vector<Vec3> places = places_of(*lights_[i]);
        extent.endless |= std::none_of(places.begin(), places.end(), [&](const Vec3& place) {
            return extent.bounds.intersects(place);
        });
    }
    if (extent.endless) {
        const Vec3 half(sphere_.radius);
        extent.bounds = Bounds(sphere_.center - half, sphere_.center + half);
    }
    return extent;
}

void TracedScene::make_medium_light(const SceneMedium& medium, const MediumExtent& extent,
                                    const FieldJobs& jobs) {
    const MediumNumber number = media_.number_of(medium.medium.get());
    const MediumNumber outside = extent.endless ? number : kNoMedium;
    const auto inside = [number, outside, meet = meet_surface()](const Vec3& position,
                                                                 const Vec3& direction) {
        return medium_along(meet, position, direction, outside) == number;
    };
    medium_lights_[number] = lights_.size();
    lights_.push_back(lxs::make_medium_light({medium.group, false},
                                             {medium.medium, extent.bounds, inside}, jobs));
    light_places_.push_back(medium.where);
    declared_media_.push_back(number);
}

void TracedScene::find_boundaries() {
    std::vector<Vec3> points;
    for (const Surface& surface : world_surfaces_.surfaces)
        append_points(surface, Matrix(), points);
    for (const Instance& instance : contents_.instances) {
        for (const Surface& surface : object_surfaces_[instance.object].surfaces)
            append_points(surface, instance.to_world, points);
    }
    const std::size_t step = points.size() / kMostBoundaries + 1;
    for (std::size_t i = 0; i < points.size(); i += step)
        boundaries_.push_back(points[i]);
}

MeetSurface TracedScene::meet_surface() const {
    return [this](const Ray& ray, SurfaceHit& hit) -> const Surface* {
        RawHit raw;
        if (!world_scene_.intersect(ray, kSmallestDistance, SurfaceClass::Any, raw)) return nullptr;
        ShadingPoint point;
        return &locate_hit(ray, raw, hit, point);
    };
}

void TracedScene::find_camera_media(Diagnostics& diagnostics) {
    const MediumNumber declared = media_.number_of(contents_.camera_medium.get());
    const std::vector<Vec3> places = camera_places(contents_);
    const auto place = std::span(places).first(std::min<std::size_t>(places.size(), 1));
    camera_media_ = media_around(meet_surface(), place, {}, kNoMedium);
    const MediumNumber endless = declared != kNoMedium ? declared : declared_at_infinity();
    if (endless == kNoMedium || camera_media_.contains(endless)) return;
    outside_ = EnteredMedia().entered(endless);
    camera_media_ = media_around(meet_surface(), place, outside_, kNoMedium);
    warn_if_not(declared, camera_media_, contents_.end, diagnostics);
}

MediumNumber TracedScene::declared_at_infinity() const {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (lights_[i]->at_infinity() && declared_media_[i] != kNoMedium) return declared_media_[i];
    }
    return kNoMedium;
}

void TracedScene::find_light_media(Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        lights_[i]->set_media(lights_[i]->at_infinity()
                                  ? outside_
                                  : media_around(meet_surface(), places_of(*lights_[i]), outside_,
                                                 declared_media_[i]));
        warn_if_not(declared_media_[i], lights_[i]->media(), light_places_[i], diagnostics);
    }
}

void TracedScene::warn_if_not(MediumNumber declared, const EnteredMedia& media,
                              const SourceLocation& where, Diagnostics& diagnostics) const {
    const MediumNumber found = media.innermost();
    if (declared == kNoMedium || same_optics(media_.medium(found), media_.medium(declared))) return;
    diagnostics.warning(
        where, fmt::format("Exterior \"{}\" is in force here, but by the surfaces around it {} "
                           "stands in {}, which is taken for it",
                           media_.name(declared),
                           where.line == contents_.end.line ? "the camera" : "the light",
                           quoted_medium(media_, found)));
}

std::vector<MediaStart> TracedScene::media_starts() const {
    std::vector<MediaStart> starts;
    for (const Vec3& place : camera_places(contents_))
        starts.push_back({place, camera_media_});
    for (const auto& light : lights_) {
        if (starts.size() >= kMostStarts) break;
        if (light->at_infinity()) continue;
        const std::vector<Vec3> places = places_of(*light);
        if (!places.empty()) starts.push_back({places.front(), light->media()});
    }
    return starts;
}

void TracedScene::warn_of_media(Diagnostics& diagnostics) const {
    for (const MediaNote& note :
         review_media(meet_surface(), media_, media_starts(), boundaries_)) {
        if (note.contradiction) diagnostics.warning(note.where, note.text);
    }
}

std::vector<std::string> TracedScene::media_notes() const {
    std::vector<std::string> notes;
    const auto add = [&](const SourceLocation& where, const std::string& text) {
        notes.push_back(where.file ? fmt::format("{}:{}: {}", where.file->name, where.line, text)
                                   : text);
    };
    const auto add_start = [&](const SourceLocation& where, const char* what,
                               const EnteredMedia& media) {
        if (media == EnteredMedia()) return;
        add(where, fmt::format("{} stands in {}", what, quoted_medium(media_, media.innermost())));
    };
    add_start(contents_.end, "the camera", camera_media_);
    for (std::size_t i = 0; i < lights_.size() && notes.size() < kMostStarts; ++i)
        add_start(light_places_[i], "the light", lights_[i]->media());
    for (const MediaNote& note : review_media(meet_surface(), media_, media_starts(), boundaries_))
        add(note.where, note.text);
    return notes;
}

}  // namespace lxs
