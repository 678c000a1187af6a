// LuxRender's scene and lights as the engine sees them.
#include "scene_shim.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "aips/core/sampling/random.h"
#include "bsdf_shim.h"
#include "convert.h"
#include "emission_numbers.h"

namespace aips::luxrender {
namespace {

/// Share of the lights' mean power that each counts for at least. The few photons that measure it
/// may all be black where a light shines in lines or its texture has few bright places, and the
/// engine leaves out lights of power 0.
constexpr float kLeastPower = 1e-3f;

constexpr std::size_t kAlignment = alignof(std::max_align_t);

/// Digits that choose among the parts of a light: enough for as many as its place has when the
/// choosing number goes from 0 to 1, at most 8.
unsigned choice_bits_of(const LuxView& view, unsigned light) {
    constexpr unsigned kProbes = 256;
    unsigned parts = 0;
    Vec3 last;
    for (unsigned i = 0; i < kProbes; ++i) {
        const float place[3] = {0.3f, 0.4f, (float(i) + 0.5f) / kProbes};
        const float direction[3] = {0.5f, 0.5f, 0.5f};
        ViewEmission emission;
        if (!view.emit(light, place, direction, emission)) continue;
        const Vec3 at = vector_of(emission.ray.origin);
        if (parts == 0 || !(at == last)) ++parts;
        last = at;
    }
    return parts > 1 ? static_cast<unsigned>(std::bit_width(parts - 1)) : 0;
}

/// Where a ray along `direction` leaves a surface without meeting it again.
Vec3 leaving(const SurfacePoint& point, Vec3 direction) {
    const float side = dot(direction, point.geometric_normal) > 0 ? 1.0f : -1.0f;
    return point.position + point.geometric_normal * (side * point.position_error.x);
}

class LightShim final : public Light {
  public:
    LightShim(const LuxView& view, unsigned index)
        : view_(view), index_(index), choice_bits_(choice_bits_of(view, index)) {}

    std::uint32_t group() const override { return view_.light_group(index_); }
    float power() const override { return power_; }
    bool at_infinity() const override { return view_.light_at_infinity(index_); }
    bool is_delta() const override { return view_.light_is_delta(index_); }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        const EmissionNumbers numbers = emission_numbers(u, choice_bits_);
        ViewEmission e;
        if (!view_.emit(index_, numbers.place.data(), numbers.direction.data(), e)) return false;
        emission = {ray_of(e.ray), rgb_of(e.power)};
        return true;
    }
    bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const override {
        const float numbers[3] = {u.x, u.y, third_number(u)};
        ViewDirect s;
        if (!view_.sample_direct(index_, to(from.position), numbers, s)) return false;
        sample.wi = vector_of(s.wi);
        sample.distance = at_infinity() ? std::numeric_limits<float>::infinity() : s.distance;
        sample.radiance = rgb_of(s.radiance);
        sample.pdf = s.pdf;
        sample.delta = s.delta;
        sample.segment_end = vector_of(s.end);
        return true;
    }
    float pdf_direct(const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const override {
        if (!at) return view_.pdf_escaping(index_, to(from.position), to(wi));
        return view_.pdf_direct(index_, to(from.position), to(at->position),
                                to(at->geometric_normal));
    }
    Rgb escaped(Vec3 direction) const override {
        return rgb_of(view_.escaped(index_, to(direction)));
    }

    /// Adds what `paths` photons at the view's wavelengths bring, as a share of `all` passes.
    void add_power(std::uint64_t pass, unsigned paths, unsigned all) {
        double sum = 0;
        for (unsigned i = 0; i < paths; ++i) {
            RandomStream random(index_, pass, i, RandomDomain::Photon);
            std::array<std::uint32_t, 4> bits;
            for (std::uint32_t& b : bits)
                b = random.next_uint();
            Emission emission;
            if (emit(primary_point(bits), emission)) sum += luminance(emission.power);
        }
        power_ += float(sum / paths / all);
    }
    void raise_power(float least) { power_ = std::max(power_, least); }

  private:
    const LuxView& view_;
    unsigned index_, choice_bits_;
    float power_ = 0;
};

}  // namespace

SceneShim::SceneShim(LuxView& view, const PassWavelengths& wavelengths)
    : view_(view), material_names_{"material"} {
    constexpr unsigned kPasses = 8, kPaths = 64;
    const auto set = [&](unsigned pass) {
        const PassWavelengths::Drawn drawn = wavelengths.of_pass(pass);
        view.set_wavelengths(drawn.nanometres, drawn.per_density);
    };
    set(0);
    std::vector<LightShim*> shims;
    for (unsigned i = 0; i < view.light_count(); ++i) {
        auto shim = std::make_unique<LightShim>(view, i);
        shims.push_back(shim.get());
        light_pointers_.push_back(shim.get());
        lights_.push_back(std::move(shim));
    }
    for (unsigned pass = 0; pass < kPasses; ++pass) {
        set(pass);
        for (LightShim* shim : shims)
            shim->add_power(pass, kPaths, kPasses);
    }
    double sum = 0;
    for (const LightShim* shim : shims)
        if (std::isfinite(shim->power())) sum += shim->power();
    const float least = sum > 0 ? kLeastPower * float(sum / double(shims.size())) : 1;
    for (LightShim* shim : shims)
        shim->raise_power(least);
}

SceneShim::~SceneShim() = default;

bool SceneShim::intersect(const Ray& ray, SurfacePoint& point,
                          std::pmr::memory_resource& memory) const {
    void* const kept = memory.allocate(view_.surface_bytes(), kAlignment);
    ViewHit hit;
    const bool met = view_.intersect(to(ray), kept, hit);
    point.distance = hit.distance;
    point.transmittance = rgb_of(hit.transmittance);
    if (!met) return false;
    point.position = vector_of(hit.position);
    point.geometric_normal = vector_of(hit.geometric_normal);
    point.shading_normal = vector_of(hit.shading_normal);
    point.position_error = {hit.error, hit.error, hit.error};
    point.emitted = rgb_of(hit.emitted);
    point.light = hit.light >= 0 ? static_cast<LightIndex>(hit.light) : kNoLight;
    point.interior = hit.interior;
    point.exterior = hit.exterior;
    point.bsdf = new (memory.allocate(sizeof(BsdfShim), alignof(BsdfShim))) BsdfShim(view_, kept);
    return true;
}

bool SceneShim::intersect_shape(const Ray& ray, SurfacePoint& point,
                                std::pmr::memory_resource& /*memory*/) const {
    ViewHit hit;
    if (!view_.intersect_shape(to(ray), hit)) return false;
    point.position = vector_of(hit.position);
    point.geometric_normal = vector_of(hit.geometric_normal);
    point.distance = hit.distance;
    return true;
}

Ray SceneShim::spawn(const SurfacePoint& point, Vec3 direction, float time) const {
    Ray ray;
    ray.origin = leaving(point, direction);
    ray.direction = direction;
    ray.time = time;
    ray.medium = dot(direction, point.geometric_normal) > 0 ? point.exterior : point.interior;
    return ray;
}

Rgb SceneShim::visibility(const SurfacePoint& point, const DirectSample& light, float time) const {
    const void* const volume =
        dot(light.wi, point.geometric_normal) > 0 ? point.exterior : point.interior;
    const Vec3 origin = leaving(point, light.wi);
    return rgb_of(view_.visibility(to(origin), to(light.segment_end), volume, time));
}

Bounds SceneShim::bounds() const {
    Triple lower, upper;
    view_.bounds(lower, upper);
    return {vector_of(lower), vector_of(upper)};
}

SceneFacts SceneShim::facts() const {
    SceneFacts facts;
    facts.max_bsdf_bytes = view_.surface_bytes() + sizeof(BsdfShim) + 2 * kAlignment;
    return facts;
}

}  // namespace aips::luxrender
