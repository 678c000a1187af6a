// Protects `path`, with plain samples and with Markov chains, from surfaces and lights that give
// what is no number: the film gets finite light only, and refusals name the material, the light or
// the passage of light that they came from.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/tracing/trace_scene.h"
#include "path/path_integrator.h"
#include "path_render.h"

namespace lxs::test::path_sample_filter_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

enum class Part {
    BsdfValue,
    BsdfPdf,
    BsdfWeight,
    Position,
    Normal,
    Emitted,
    HitTransmittance,
    DirectRadiance,
    DirectPdf,
    PdfDirect,
    Escaped,
    Transmittance
};

struct Spoil {
    Part part = Part::BsdfValue;
    float value = 0;
};

class SpoiledBsdf final : public Bsdf {
  public:
    SpoiledBsdf(const Bsdf& inner, const Spoil& spoil) : inner_(inner), spoil_(spoil) {}
    LobeMask lobes() const override { return inner_.lobes(); }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                 LobeMask mask) const override {
        Rgb f = inner_.evaluate(wo, wi, transport, mask);
        if (spoil_.part == Part::BsdfValue) f.x = spoil_.value;
        return f;
    }
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override {
        return spoil_.part == Part::BsdfPdf ? spoil_.value : inner_.pdf(wo, wi, mask);
    }
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override {
        if (!inner_.sample(wo, u, u_lobe, transport, mask, sample)) return false;
        if (spoil_.part == Part::BsdfWeight) sample.weight.x = spoil_.value;
        if (spoil_.part == Part::BsdfPdf) sample.pdf = spoil_.value;
        return true;
    }
    Rgb albedo(const Vec3& wo, LobeMask mask) const override { return inner_.albedo(wo, mask); }

  private:
    const Bsdf& inner_;
    Spoil spoil_;
};

class SpoiledLight final : public Light {
  public:
    SpoiledLight(const Light& light, const Spoil& spoil) : light_(light), spoil_(spoil) {}
    std::string_view kind() const override { return light_.kind(); }
    std::uint32_t group() const override { return light_.group(); }
    float power() const override { return light_.power(); }
    bool at_infinity() const override { return light_.at_infinity(); }
    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override {
        return light_.sample_emission(u, sample);
    }
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override {
        if (!light_.sample_direct(p, n, u, sample)) return false;
        if (spoil_.part == Part::DirectRadiance) sample.radiance.x = spoil_.value;
        if (spoil_.part == Part::DirectPdf) sample.pdf = spoil_.value;
        return true;
    }
    float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                     const Vec3& light_n, std::uint32_t primitive) const override {
        return spoil_.part == Part::PdfDirect
                   ? spoil_.value
                   : light_.pdf_direct(p, n, wi, light_p, light_n, primitive);
    }
    Rgb escaped(const Vec3& direction) const override {
        Rgb seen = light_.escaped(direction);
        if (spoil_.part == Part::Escaped) seen.x = spoil_.value;
        return seen;
    }

  private:
    const Light& light_;
    Spoil spoil_;
};

/// A scene whose material "bad" and whose lights are spoiled.
class SpoiledScene final : public Scene {
  public:
    SpoiledScene(const Scene& scene, const Spoil& spoil) : scene_(scene), spoil_(spoil) {
        for (const Light* light : scene.lights()) {
            lights_.push_back(std::make_unique<SpoiledLight>(*light, spoil));
            pointers_.push_back(lights_.back().get());
        }
        const auto names = scene.material_names();
        bad_ = static_cast<std::uint32_t>(std::find(names.begin(), names.end(), "bad") -
                                          names.begin());
    }
    bool intersect(const Ray& ray, SurfaceHit& hit,
                   std::pmr::memory_resource& memory) const override {
        const bool met = scene_.intersect(ray, hit, memory);
        if (spoil_.part == Part::HitTransmittance) hit.transmittance.x = spoil_.value;
        if (!met) return false;
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            if (hit.light == scene_.lights()[i]) hit.light = pointers_[i];
        }
        if (spoil_.part == Part::Emitted) hit.emitted.x = spoil_.value;
        if (hit.material != bad_ || !hit.bsdf) return true;
        if (spoil_.part == Part::Position) hit.p.y = spoil_.value;
        if (spoil_.part == Part::Normal) hit.ns.x = spoil_.value;
        hit.bsdf = new (memory.allocate(sizeof(SpoiledBsdf), alignof(SpoiledBsdf)))
            SpoiledBsdf(*hit.bsdf, spoil_);
        return true;
    }
    Rgb transmittance(const Ray& ray) const override {
        Rgb passed = scene_.transmittance(ray);
        if (spoil_.part == Part::Transmittance) passed.x = spoil_.value;
        return passed;
    }
    const Medium* medium(const EnteredMedia& media) const override { return scene_.medium(media); }
    std::span<const Light* const> lights() const override { return pointers_; }
    std::span<const std::string> light_groups() const override { return scene_.light_groups(); }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    Bounds bounds() const override { return scene_.bounds(); }
    SceneFacts facts() const override {
        SceneFacts facts = scene_.facts();
        facts.max_bsdf_bytes += sizeof(SpoiledBsdf) + alignof(SpoiledBsdf);
        return facts;
    }

  private:
    const Scene& scene_;
    Spoil spoil_;
    std::uint32_t bad_ = 0;  // index of the spoiled material
    std::vector<std::unique_ptr<SpoiledLight>> lights_;
    std::vector<const Light*> pointers_;
};

class Silent : public Diagnostics, public Log {
  public:
    void warning(const SourceLocation& where, const std::string& message) override {
        ADD_FAILURE() << format_message(where, "warning", message);
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        warning(where, message);
    }
    void info(std::string_view /*message*/) override {}
    void warning(std::string_view /*message*/) override {}
    void debug(std::string_view /*message*/) override {}
};

/// A lamp above a floor named "bad", under a sky; nothing else has a material.
std::string lamp_over_floor(const std::string& sampler) {
    return sampler +
           "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [8]\n" +
           camera_above(2, 60) +
           "AttributeBegin\nMakeNamedMaterial \"lamp\" \"string type\" [\"matte\"]\n"
           "NamedMaterial \"lamp\"\nAreaLightSource \"area\" \"color L\" [5 4 3] "
           "\"float power\" [0] \"float efficacy\" [0]\n" +
           square(3, 3, true) +
           "AttributeEnd\nLightSource \"infinite\" \"color L\" [1 1 2]\n"
           "MakeNamedMaterial \"bad\" \"string type\" [\"matte\"]\nNamedMaterial \"bad\"\n" +
           square(0, 1) + "WorldEnd\n";
}

InvalidSampleList refusals_of(const std::string& text, const Spoil& spoil) {
    Silent messages;
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    SceneContents contents = read_scene_text(text, "test", ".", registry, messages);
    const auto film = make_film(contents, messages);
    const auto camera = make_camera(contents, *film, messages);
    const auto sampler = make_sampler(contents, 1, messages, true);
    const auto scene = make_trace_scene(std::move(contents), {}, messages);
    const SpoiledScene spoiled(*scene, spoil);
    PathIntegrator integrator{PathSettings{}};
    integrator.prepare({spoiled, *camera, *sampler, *film, messages, {0, 1}});
    for (std::uint64_t pass = 0; pass < 8; ++pass)
        integrator.render_pass(pass);
    EXPECT_EQ(film->refused_samples(), 0u);
    return integrator.invalid_samples();
}

TEST(PathSampleFilter, EverythingThatASceneGives) {
    const std::string material = R"(material "bad")", lamp = "light 0 (area)",
                      sky = "light 1 (infinite)",
                      passage = "media or surfaces that light passes straight";
    const std::vector<std::pair<Part, std::vector<std::string>>> cases{
        {Part::BsdfValue, {material}},
        {Part::BsdfPdf, {material}},
        {Part::BsdfWeight, {material}},
        {Part::Position, {material}},
        {Part::Normal, {material}},
        {Part::Emitted, {lamp}},
        {Part::HitTransmittance, {passage}},
        {Part::DirectRadiance, {lamp, sky}},
        {Part::DirectPdf, {lamp, sky}},
        {Part::PdfDirect, {lamp, sky}},
        {Part::Escaped, {sky}},
        {Part::Transmittance, {passage}}};
    for (const std::string sampler : {"", "Sampler \"metropolis\"\n"}) {
        for (const auto& [part, origins] : cases) {
            for (const float value : {kNan, kInfinity, -1.0f}) {
                const bool place = part == Part::Position || part == Part::Normal;
                // An infinite density leaves everything to the other strategy.
                if ((place && value == -1) || (part == Part::PdfDirect && value == kInfinity))
                    continue;
                SCOPED_TRACE(sampler + "part " + std::to_string(int(part)) + " = " +
                             std::to_string(value));
                std::vector<std::string> found;
                for (const InvalidSamples& invalid :
                     refusals_of(lamp_over_floor(sampler), {part, value})) {
                    found.push_back(invalid.origin);
                    EXPECT_GT(invalid.count, 0u);
                }
                EXPECT_EQ(found, origins);
            }
        }
    }
}

}  // namespace
}  // namespace lxs::test::path_sample_filter_test
