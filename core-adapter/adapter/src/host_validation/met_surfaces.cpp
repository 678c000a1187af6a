// What must hold at every surface, whatever it is made of.
#include "met_surfaces.h"

#include "aips/core/sampling/sampling.h"
#include "tolerances.h"

namespace aips {
namespace {

/// Bounces of a path on which surfaces are met.
constexpr int kMostBounces = 6;

/// Places that are kept of all surfaces met.
constexpr std::size_t kPlacesAnywhere = 256;

/// Counts what one intersect() takes of an arena.
class CountedMemory final : public std::pmr::memory_resource {
  public:
    explicit CountedMemory(Arena& arena) : arena_(arena) {}
    std::size_t bytes() const { return bytes_; }

  private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        bytes_ += bytes + alignment - 1;  // wherever the block begins
        return arena_.allocate(bytes, alignment);
    }
    void do_deallocate(void*, std::size_t, std::size_t) override {}
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        return this == &other;
    }
    Arena& arena_;
    std::size_t bytes_ = 0;
};

bool is_unit(Vec3 v) {
    return std::abs(length_squared(v) - 1) < 1e-3f;
}

std::string text(Vec3 v) {
    std::string text = figure(v.x);
    text.append(", ").append(figure(v.y)).append(", ").append(figure(v.z));
    return text;
}

/// Rounding of coordinates in a scene: some units in the last place of the farthest.
float coarseness_of(const Bounds& bounds) {
    if (bounds.empty()) return 0;
    const Vec3 reach = max(abs(bounds.lower), abs(bounds.upper));
    return 16 * 0x1p-23f * std::max({reach.x, reach.y, reach.z});
}

Vec3 somewhere_in(const Bounds& bounds, RandomStream& random) {
    const Vec3 e = bounds.extent();
    const Vec2 xy = random.next2();
    return bounds.lower + Vec3{e.x * xy.x, e.y * xy.y, e.z * random.next()};
}

}  // namespace

MetSurfaces::MetSurfaces(const Scene& scene, const HostValidationSettings& settings,
                         HostFindings& findings)
    : scene_(scene),
      settings_(settings),
      random_(check_stream(settings, CheckStream::Rays, 0)),
      facts_(scene.facts()),
      coarseness_(coarseness_of(scene.bounds())) {
    shoot();
    report(findings);
}

/// From the lights in turn, and between them from places within the scene.
void MetSurfaces::shoot() {
    const auto lights = scene_.lights();
    const Bounds bounds = scene_.bounds();
    for (std::uint32_t i = 0; i < settings_.rays; ++i) {
        if (i % 2 == 0 && !lights.empty()) {
            const auto light = LightIndex((i / 2) % lights.size());
            Emission emission;
            if (!emit_at_random(*lights[light], random_, emission)) continue;
            if (!is_unit(emission.ray.direction) || !is_finite(emission.ray.origin)) continue;
            emission.ray.time = settings_.time;
            follow(emission.ray, light);
        } else if (!bounds.empty()) {
            const Vec3 direction = square_to_uniform_sphere(random_.next2());
            follow({somewhere_in(bounds, random_), direction, settings_.time}, kNoLight);
        }
    }
}

void MetSurfaces::follow(Ray ray, LightIndex from) {
    SurfacePoint left;  // the surface that the ray leaves
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        Arena arena;
        CountedMemory memory(arena);
        SurfacePoint point;
        if (!scene_.intersect(ray, point, memory)) return;
        const auto met = [&] {
            return material_subject(scene_, point.material) + " met again at distance " +
                   figure(point.distance);
        };
        if (bounce > 0) {
            spawned_.look(!same_surface(left, point), met);
        } else if (from != kNoLight && !scene_.lights()[from]->at_infinity()) {
            emitted_starts_.look(!behind_light(ray, point, from), met);
        }
        look_at(ray, point, memory.bytes());
        BsdfSample sample;
        if (!point.bsdf || !is_finite(point.position)) return;
        const Vec2 u = random_.next2();
        if (!point.bsdf->sample(-ray.direction, u, random_.next(), Transport::Power, kAllLobes,
                                sample) ||
            !is_unit(sample.wi)) {
            return;
        }
        ray = continue_ray(scene_, point, sample.wi, sample.component, ray);
        left = point;
    }
}

/// Flat within the distance that is looked at; sheets one above another are different surfaces.
bool MetSurfaces::same_surface(const SurfacePoint& a, const SurfacePoint& b) const {
    const Vec3 apart = b.position - a.position;
    return a.material == b.material && length(apart) < kClose * coarseness_ &&
           std::abs(dot(apart, a.geometric_normal)) < coarseness_ &&
           dot(a.geometric_normal, b.geometric_normal) > 0.999f;
}

/// Whether a photon started behind its emitter and meets its back; the front of a concave emitter
/// is met rightly. Backs may be no light: a ray the other way tells.
bool MetSurfaces::behind_light(const Ray& ray, const SurfacePoint& met, LightIndex from) const {
    const float close = kClose * coarseness_;
    if (dot(ray.direction, met.geometric_normal) <= 0) return false;
    if (length(met.position - ray.origin) >= close) return false;
    if (met.light == from) return true;
    Ray back = scene_.spawn(met, ray.direction, ray.time);
    back.origin = back.origin + ray.direction * close;
    back.direction = -ray.direction;
    Arena arena;
    SurfacePoint front;
    return scene_.intersect(back, front, arena) && front.light == from &&
           front.distance < 2 * close;
}

void MetSurfaces::look_at(const Ray& ray, const SurfacePoint& point, std::size_t bytes) {
    const auto subject = [&] { return material_subject(scene_, point.material); };
    memory_.look(bytes <= facts_.max_bsdf_bytes,
                 [&] { return std::to_string(bytes) + " bytes for " + subject(); });
    if (point.bsdf) {
        const LobeMask unknown = LobeMask(point.bsdf->lobes() & ~facts_.lobes);
        lobes_.look(unknown == 0,
                    [&] { return "lobe " + std::to_string(unknown) + " of " + subject(); });
    }
    values_.look(is_valid_radiance(point.emitted) && is_valid_radiance(point.transmittance) &&
                     std::isfinite(point.distance) && is_finite(point.position),
                 [&] { return "a value that is negative or not finite at " + subject(); });
    indices_.look((point.light == kNoLight || point.light < scene_.lights().size()) &&
                      point.material < scene_.material_names().size(),
                  [&] { return subject() + ", light " + std::to_string(point.light); });
    look_at_normals(point);
    look_at_place(ray, point);
    keep(ray, point);
}

void MetSurfaces::look_at_place(const Ray& ray, const SurfacePoint& point) {
    const auto subject = [&] { return material_subject(scene_, point.material); };
    const Vec3 along = ray.origin + ray.direction * point.distance;
    const float slack = 1e-3f * point.distance + 16 * coarseness_;
    positions_.look(length(along - point.position) <= slack, [&] {
        return subject() + " at " + text(point.position) + ", the ray at " + text(along);
    });
    const Bounds b = scene_.bounds();
    const float margin = 1e-3f * b.diagonal() + coarseness_;
    const Vec3 room{margin, margin, margin};
    bounds_.look(Bounds{b.lower - room, b.upper + room}.contains(point.position),
                 [&] { return subject() + " at " + text(point.position); });
}

void MetSurfaces::look_at_normals(const SurfacePoint& point) {
    const auto subject = [&] { return material_subject(scene_, point.material); };
    const bool unit =
        normals_.look(is_unit(point.geometric_normal) && is_unit(point.shading_normal), [&] {
            return "lengths " + figure(length(point.geometric_normal)) + " and " +
                   figure(length(point.shading_normal)) + " at " + subject();
        });
    if (!unit) return;
    const float cosine = dot(point.geometric_normal, point.shading_normal);
    hemispheres_.look(cosine > 0, [&] { return "cosine " + figure(cosine) + " at " + subject(); });
}

void MetSurfaces::keep(const Ray& ray, const SurfacePoint& point) {
    Places& places = materials_[point.material];
    if (dot(ray.direction, point.geometric_normal) < 0) {
        keep(ray, places.front, places.met_front);
    } else {
        keep(ray, places.back, places.met_back);
    }
    ++met_;
    if (anywhere_.size() < kPlacesAnywhere) {
        anywhere_.push_back(ray);
    } else if (const auto at = std::size_t(random_.next() * float(met_)); at < kPlacesAnywhere) {
        anywhere_[at] = ray;
    }
}

/// Of all rays that meet the material, each is kept with the same probability.
void MetSurfaces::keep(const Ray& ray, std::vector<Ray>& rays, std::uint64_t& met) {
    ++met;
    if (rays.size() < settings_.places) {
        rays.push_back(ray);
    } else if (const auto at = std::size_t(random_.next() * float(met)); at < rays.size()) {
        rays[at] = ray;
    }
}

void MetSurfaces::report(HostFindings& findings) {
    const std::string scene = "scene";
    findings.add_if_over(memory_, 0, scene, "memory",
                         "at most max_bsdf_bytes, " + std::to_string(facts_.max_bsdf_bytes) +
                             ", alignment less 1 included");
    findings.add_if_over(
        lobes_, 0, scene, "lobes",
        "no lobe that SceneFacts::lobes, " + std::to_string(facts_.lobes) + ", lacks");
    for (const bool wrong :
         {findings.add_if_over(values_, 0, scene, "values", "finite values, none negative"),
          findings.add_if_over(indices_, 0, scene, "indices",
                               "a light of lights() or kNoLight, a name in material_names()"),
          findings.add_if_over(normals_, 0, scene, "normals", "unit normals"),
          findings.add_if_over(hemispheres_, 0, scene, "shading normal",
                               "one in the geometric normal's hemisphere"),
          findings.add_if_over(positions_, kRare, scene, "position",
                               "the point at `distance` along the ray"),
          findings.add_if_over(spawned_, kRare, scene, "spawn",
                               "rays that do not meet the surface they leave")})
        sound_ = sound_ && !wrong;
    findings.add_if_over(bounds_, kRare, scene, "bounds", "surfaces within bounds()");
    findings.add_if_over(emitted_starts_, kRare, scene, "start of emission",
                         "photons that do not meet the surface they leave");
    if (scene_.media() && !facts_.has_media) {
        findings.add({scene, "media", "media(), but no SceneFacts::has_media", "both or neither"});
    }
}

}  // namespace aips
