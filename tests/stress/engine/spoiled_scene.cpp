// Spoiled surfaces and lights.
#include "spoiled_scene.h"

#include <array>
#include <new>

#include "scene_with_lights.h"

namespace mock {
namespace {

using namespace aips;

constexpr std::array<std::string_view, 23> kNames{
    "BSDF value",          "BSDF density",        "BSDF sample weight",
    "BSDF albedo",         "BSDF direction",      "reflectance",
    "surface position",    "surface distance",    "geometric normal",
    "shading normal",      "emitted radiance",    "photon power",
    "photon origin",       "photon direction",    "light's radiance",
    "light's density",     "light's direction",   "light's density of a direction",
    "radiance of the sky", "light's coordinates", "light's power",
    "transmittance",       "visibility"};

Rgb rgb(float v) {
    return {v, v, v};
}
/// The channel that is spoiled: others stay, as a single bad channel has to be found too.
Rgb with_red(Rgb c, float red) {
    return {red, c.g, c.b};
}

class SpoiledBsdf final : public Bsdf {
  public:
    SpoiledBsdf(const Bsdf& inner, const Spoil& spoil) : inner_(inner), spoil_(spoil) {}

    LobeMask lobes() const override { return inner_.lobes(); }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override {
        const Rgb f = inner_.evaluate(wo, wi, transport, mask);
        return is(Part::BsdfValue) ? with_red(f, spoil_.value) : f;
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        return is(Part::BsdfPdf) ? spoil_.value : inner_.pdf(wo, wi, mask);
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override {
        if (!inner_.sample(wo, u, u_lobe, transport, mask, sample)) return false;
        if (is(Part::BsdfPdf) && sample.lobe != kSpecular) sample.pdf = spoil_.value;
        if (is(Part::BsdfWeight)) sample.weight = with_red(sample.weight, spoil_.value);
        if (is(Part::BsdfDirection)) sample.wi.y = spoil_.value;
        return true;
    }
    Rgb albedo(Vec3 wo, LobeMask mask) const override {
        return is(Part::BsdfAlbedo) ? rgb(spoil_.value) : inner_.albedo(wo, mask);
    }
    bool lambertian(Rgb& kd) const override {
        if (!is(Part::LambertReflectance) || !inner_.lambertian(kd)) return false;
        kd = with_red(kd, spoil_.value);
        return true;
    }

  private:
    bool is(Part part) const { return spoil_.part == part; }
    const Bsdf& inner_;
    Spoil spoil_;
};

class SpoiledLight final : public LightLike {
  public:
    SpoiledLight(const Light& light, const Spoil& spoil) : LightLike(light), spoil_(spoil) {}

    std::string name() const override { return "spoiled"; }
    float power() const override {
        return is(Part::LightsOwnPower) ? spoil_.value : LightLike::power();
    }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        if (!LightLike::emit(u, emission)) return false;
        if (is(Part::LightPower)) emission.power = with_red(emission.power, spoil_.value);
        if (is(Part::LightOrigin)) emission.ray.origin.x = spoil_.value;
        if (is(Part::LightDirection)) emission.ray.direction.x = spoil_.value;
        return true;
    }
    bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const override {
        if (!LightLike::sample_direct(from, u, sample)) return false;
        if (is(Part::DirectRadiance)) sample.radiance = with_red(sample.radiance, spoil_.value);
        if (is(Part::DirectPdf)) sample.pdf = spoil_.value;
        if (is(Part::DirectDirection)) sample.wi.z = spoil_.value;
        return true;
    }
    float pdf_direct(const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const override {
        return is(Part::PdfDirect) ? spoil_.value : LightLike::pdf_direct(from, wi, at);
    }
    Rgb escaped(Vec3 direction) const override {
        const Rgb seen = LightLike::escaped(direction);
        return is(Part::Escaped) ? with_red(seen, spoil_.value) : seen;
    }
    bool emission_coordinates(const SurfacePoint& /*towards*/, const DirectSample& /*sample*/,
                              PrimaryPoint& u) const override {
        u[0] = spoil_.value;
        return is(Part::EmissionCoordinates);
    }

  private:
    bool is(Part part) const { return spoil_.part == part; }
    Spoil spoil_;
};

bool of_bsdf(Part part) {
    return part <= Part::LambertReflectance;
}
bool of_light(Part part) {
    return part >= Part::LightPower && part <= Part::LightsOwnPower;
}

}  // namespace

std::string_view name(Part part) {
    return kNames[static_cast<std::size_t>(part)];
}

SpoiledScene::SpoiledScene(const Scene& scene, const Spoil& spoil)
    : scene_(scene), spoil_(spoil), lights_(scene.lights().begin(), scene.lights().end()) {
    if (!of_light(spoil.part)) return;
    spoiled_light_ = std::make_unique<SpoiledLight>(*lights_[spoil.index], spoil);
    lights_[spoil.index] = spoiled_light_.get();
}

SpoiledScene::~SpoiledScene() = default;

bool SpoiledScene::intersect(const Ray& ray, SurfacePoint& point,
                             std::pmr::memory_resource& memory) const {
    const bool met = scene_.intersect(ray, point, memory);
    if (spoil_.part == Part::Transmittance) point.transmittance = rgb(spoil_.value);
    if (!met || point.material != spoil_.index) return met;
    if (of_bsdf(spoil_.part)) {
        point.bsdf = new (memory.allocate(sizeof(SpoiledBsdf), alignof(SpoiledBsdf)))
            SpoiledBsdf(*point.bsdf, spoil_);
    }
    if (spoil_.part == Part::SurfacePosition) point.position.y = spoil_.value;
    if (spoil_.part == Part::SurfaceDistance) point.distance = spoil_.value;
    if (spoil_.part == Part::GeometricNormal) point.geometric_normal.x = spoil_.value;
    if (spoil_.part == Part::ShadingNormal) point.shading_normal.x = spoil_.value;
    if (spoil_.part == Part::Emitted && point.light != kNoLight)
        point.emitted = with_red(point.emitted, spoil_.value);
    return met;
}

Rgb SpoiledScene::visibility(const SurfacePoint& point, const DirectSample& light,
                             float time) const {
    const Rgb seen = scene_.visibility(point, light, time);
    return spoil_.part == Part::Visibility ? with_red(seen, spoil_.value) : seen;
}

SceneFacts SpoiledScene::facts() const {
    SceneFacts facts = scene_.facts();
    facts.max_bsdf_bytes += sizeof(SpoiledBsdf) + alignof(SpoiledBsdf);
    return facts;
}

}  // namespace mock
