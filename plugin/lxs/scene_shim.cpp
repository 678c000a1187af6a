// The host's scene, lights and scattering functions in the engine's terms.
#include "scene_shim.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <new>

#include "convert.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"
#include "media_shim.h"

namespace aips::shim {
namespace {

/// Lobe masks have the same bits on both sides.
static_assert(kDiffuse == lxs::kDiffuse && kGlossy == lxs::kGlossy && kSpecular == lxs::kSpecular);

class BsdfShim final : public Bsdf {
  public:
    explicit BsdfShim(const lxs::Bsdf& bsdf) : bsdf_(bsdf) {}

    LobeMask lobes() const override { return bsdf_.lobes(); }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override {
        return from(bsdf_.evaluate(to(wo), to(wi), to(transport), mask));
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        return bsdf_.pdf(to(wo), to(wi), mask);
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override {
        lxs::BsdfSample s;
        if (!bsdf_.sample(to(wo), to(u), u_lobe, to(transport), mask, s)) return false;
        sample = {from(s.wi), from(s.weight), s.pdf, s.lobe, s.straight, s.component};
        return true;
    }
    float first_specular(Vec3 wo) const override { return bsdf_.first_specular(to(wo)); }
    Rgb albedo(Vec3 wo, LobeMask mask) const override { return from(bsdf_.albedo(to(wo), mask)); }
    bool lambertian(Rgb& kd) const override {
        lxs::Rgb value;
        if (!bsdf_.lambertian(value)) return false;
        kd = from(value);
        return true;
    }

  private:
    const lxs::Bsdf& bsdf_;
};

/// lxs::Bsdf::lambertian() in the engine's terms: the commonest Bsdf without a second dispatch.
class LambertShim final : public Bsdf {
  public:
    LambertShim(const lxs::Rgb& kd, const lxs::SurfaceHit& hit)
        : kd_(from(kd)), ng_(from(hit.ng)), ns_(from(hit.ns)) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport, LobeMask mask) const override {
        return (mask & kDiffuse) && same_side(wo, wi) ? kd_ * lxs::kInvPi : Rgb{};
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        return (mask & kDiffuse) && same_side(wo, wi) ? abs_dot(wi, ns_) * lxs::kInvPi : 0;
    }
    bool sample(Vec3 wo, Vec2 u, float, Transport, LobeMask mask,
                BsdfSample& sample) const override {
        if (!(mask & kDiffuse)) return false;
        Vec3 wi = from(
            lxs::Frame(to(ns_)).to_world(lxs::square_to_cosine_hemisphere(lxs::Vec2(u.x, u.y))));
        // The part that ns leaves out of the geometric hemisphere is filled by opposites.
        if (dot(wi, ng_) * dot(wo, ng_) < 0) wi = -wi;
        const float cosine = abs_dot(wi, ns_);
        if (!same_side(wo, wi) || cosine == 0) return false;
        sample = {wi, kd_, cosine * lxs::kInvPi, kDiffuse, false};
        return true;
    }
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kDiffuse ? kd_ : Rgb{}; }
    bool lambertian(Rgb& kd) const override {
        kd = kd_;
        return true;
    }

  private:
    bool same_side(Vec3 a, Vec3 b) const { return dot(a, ng_) * dot(b, ng_) > 0; }

    Rgb kd_;
    Vec3 ng_, ns_;
};

/// Values in the host's terms, in memory that is kept from pass to pass.
template <class From, class To>
void convert(std::span<const From> from, std::vector<To>& converted) {
    converted.resize(from.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.size(), 4096),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                              converted[i] = to(from[i]);
                      });
}

constexpr std::size_t kShimBytes = std::max(sizeof(BsdfShim), sizeof(LambertShim));

/// The host's Bsdf at a hit, built in `memory`.
const Bsdf* shim(const lxs::SurfaceHit& hit, std::pmr::memory_resource& memory) {
    void* const place = memory.allocate(kShimBytes, alignof(BsdfShim));
    lxs::Rgb kd;
    if (hit.bsdf->lambertian(kd)) return new (place) LambertShim(kd, hit);
    return new (place) BsdfShim(*hit.bsdf);
}

class LightShim final : public Light {
  public:
    explicit LightShim(const lxs::Light& light) : light_(light) {}

    std::string name() const override { return std::string(light_.kind()); }
    std::uint32_t group() const override { return light_.group(); }
    float power() const override { return light_.power(); }
    bool at_infinity() const override { return light_.at_infinity(); }
    bool hidden_from_camera() const override { return light_.hidden_from_camera(); }
    bool is_delta() const override { return light_.is_delta(); }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        lxs::EmissionSample s;
        if (!light_.sample_emission(u, s)) return false;
        emission = {from(s.ray), from(s.power)};
        return true;
    }
    bool sample_direct(const SurfacePoint& point, Vec2 u, DirectSample& sample) const override {
        lxs::DirectSample s;
        if (!light_.sample_direct(to(point.position), to(point.shading_normal), to(u), s)) {
            return false;
        }
        sample = {from(s.wi), s.distance,          from(s.radiance), s.pdf,
                  s.delta,    from(s.segment_end), s.primitive};
        return true;
    }
    bool emission_coordinates(const SurfacePoint& towards, const DirectSample& sample,
                              PrimaryPoint& u) const override {
        return light_.emission_coordinates(to(towards.position), to(sample), u);
    }
    float pdf_direct(const SurfacePoint& point, Vec3 wi, const SurfacePoint* at) const override {
        return light_.pdf_direct(to(point.position), to(point.shading_normal), to(wi),
                                 at ? to(at->position) : lxs::Vec3(0.0f),
                                 at ? to(at->geometric_normal) : lxs::Vec3(0.0f),
                                 at ? at->primitive : 0);
    }
    Rgb escaped(Vec3 direction) const override { return from(light_.escaped(to(direction))); }

  private:
    const lxs::Light& light_;
};

}  // namespace

SceneShim::SceneShim(const lxs::Scene& scene) : scene_(scene) {
    if (scene.facts().has_scattering_media) media_ = make_media_shim(scene);
    for (const lxs::Light* light : scene.lights()) {
        index_of_.emplace(light, static_cast<LightIndex>(lights_.size()));
        lights_.push_back(std::make_unique<LightShim>(*light));
        light_pointers_.push_back(lights_.back().get());
    }
}

SceneShim::~SceneShim() = default;

bool SceneShim::intersect(const Ray& ray, SurfacePoint& point,
                          std::pmr::memory_resource& memory) const {
    lxs::SurfaceHit hit;
    return take(scene_.intersect(to(ray), hit, memory), hit, point, memory);
}

bool SceneShim::intersect_specular(const Ray& ray, SurfacePoint& point,
                                   std::pmr::memory_resource& memory) const {
    lxs::SurfaceHit hit;
    return take(scene_.intersect_specular(to(ray), hit, memory), hit, point, memory);
}

bool SceneShim::intersect_shape(const Ray& ray, SurfacePoint& point,
                                std::pmr::memory_resource& memory) const {
    lxs::SurfaceHit hit;
    if (!scene_.intersect_shape(to(ray), hit, memory)) return false;
    point.position = from(hit.p);
    point.geometric_normal = from(hit.ng);
    point.distance = hit.distance;
    return true;
}

bool SceneShim::take(bool met, const lxs::SurfaceHit& hit, SurfacePoint& point,
                     std::pmr::memory_resource& memory) const {
    point.distance = hit.distance;
    point.transmittance = from(hit.transmittance);
    point.crossed = mark_of(hit.crossed);
    if (hit.medium_light) {
        point.medium_light = index_of_.at(hit.medium_light);
        point.medium_emitted = from(hit.medium_emitted);
    }
    if (!met) return false;
    point.position = from(hit.p);
    point.geometric_normal = from(hit.ng);
    point.shading_normal = from(hit.ns);
    point.emitted = from(hit.emitted);
    point.light = hit.light ? index_of_.at(hit.light) : kNoLight;
    point.material = hit.material;
    point.object = hit.object;
    point.primitive = hit.primitive;
    point.position_error = from(hit.p_error);
    point.interior = mark_of(hit.interior);
    point.exterior = mark_of(hit.exterior);
    if (hit.bsdf) point.bsdf = shim(hit, memory);
    return true;
}

Ray SceneShim::spawn(const SurfacePoint& point, Vec3 direction, float time) const {
    return from(lxs::spawn_ray(to_hit(point), to(direction), time));
}

Rgb SceneShim::visibility(const SurfacePoint& point, const DirectSample& light, float time) const {
    return from(scene_.transmittance(lxs::shadow_ray(to_hit(point), to(light), time)));
}

bool SceneShim::blocked(Vec3 from, Vec3 to, float time) const {
    lxs::Ray ray;
    ray.origin = lxs::Vec3(from.x, from.y, from.z);
    ray.direction = lxs::Vec3(to.x, to.y, to.z) - ray.origin;
    ray.t_max = ray.direction.length();
    if (!(ray.t_max > 0)) return false;
    ray.direction /= ray.t_max;
    ray.time = time;
    return lxs::is_black(scene_.transmittance(ray));
}

Bounds SceneShim::bounds() const {
    const lxs::Bounds b = scene_.bounds();
    return b.isEmpty() ? Bounds{} : Bounds{from(b.min), from(b.max)};
}

SceneFacts SceneShim::facts() const {
    const lxs::SceneFacts f = scene_.facts();
    SceneFacts facts;
    facts.lobes = LobeMask((f.has_diffuse ? kDiffuse : 0) | (f.has_glossy ? kGlossy : 0) |
                           (f.has_specular ? kSpecular : 0));
    facts.has_media = f.has_media;
    facts.max_bsdf_bytes = f.max_bsdf_bytes + kShimBytes + alignof(BsdfShim);
    return facts;
}

CameraRay CameraShim::generate(const CameraSample& sample, float time) const {
    lxs::CameraSample s;
    s.film = to(sample.film);
    s.lens = to(sample.lens);
    const lxs::CameraRay ray = camera_.generate(s, time);
    return {from(ray.ray), ray.width, ray.spread, ray.depth, ray.depth_per_distance};
}

CameraSample SamplerShim::camera_sample(std::uint64_t number, std::uint32_t x,
                                        std::uint32_t y) const {
    const lxs::CameraSample s = sampler_.camera_sample(number, x, y);
    return {{s.film.x, s.film.y}, {s.lens.x, s.lens.y}};
}

lxs::PassSamples FilmShim::samples_of(const FilmPass& pass) {
    convert(pass.positions, positions_);
    convert(pass.eye, radiance_);
    convert(pass.photons, photons_);
    return {.positions = positions_,
            .radiance = radiance_,
            .groups = pass.groups,
            .second_radiance = photons_,
            .second_weight = pass.photon_weight};
}

lxs::PassSplats FilmShim::splats_of(const FilmPass& pass) {
    convert(pass.splats->positions, positions_);
    convert(pass.splats->radiance, radiance_);
    return {.positions = positions_,
            .radiance = radiance_,
            .groups = pass.groups,
            .samples = double(width()) * height()};
}

void FilmShim::add_pass(const FilmPass& pass) {
    film_.add_pass(samples_of(pass));
    if (pass.splats) film_.add_splats(splats_of(pass));
}

void FilmShim::add_parts(const FilmPass& parts) {
    film_.add_parts(samples_of(parts));
    if (parts.splats) film_.add_splats_of_parts(splats_of(parts));
}

LayersWanted FilmShim::layers_wanted() const {
    const lxs::LayersWanted wanted = film_.layers_wanted();
    return {.parts = wanted.parts(), .surfaces = wanted.surfaces(), .bias = wanted.bias};
}

void FilmShim::add_surfaces(std::span<const Vec2> positions,
                            std::span<const SeenSurface> surfaces) {
    convert(positions, positions_);
    convert(surfaces, surfaces_);
    film_.add_surfaces(positions_, surfaces_);
}

void FilmShim::add_bias(const BiasSamples& samples) {
    lxs::PassSamples pass =
        samples_of({samples.positions, 1, samples.half, samples.whole, samples.weight});
    pass.weight = samples.weight;
    film_.add_bias(pass);
}

void FilmShim::add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                              std::span<const Rgb> values, double weight) {
    convert(positions, positions_);
    convert(values, radiance_);
    film_.add_layer_pass(name, {.positions = positions_, .radiance = radiance_, .weight = weight});
}

}  // namespace aips::shim
