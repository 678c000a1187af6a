// Makes each kind of plugin and uses it once.
#include "plugin_uses.h"

#include <algorithm>
#include <memory_resource>

#include "input_files.h"
#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/constant_texture.h"

namespace fuzz {
namespace {

using lxs::ParameterSet;
using lxs::Rgb;
using lxs::Vec2;
using lxs::Vec3;

lxs::TexturePoint texture_point(float at) {
    lxs::TexturePoint point;
    point.p = Vec3(at, 2 * at, -at);
    point.n = Vec3(0, 0, 1);
    point.uv = Vec2(at, 1 - at);
    return point;
}

void use(const lxs::Geometry& geometry) {
    lxs::Primitive primitive;
    primitive.geometry = geometry;
    primitive.emission.emplace();
    primitive.emission->radiance = std::make_shared<lxs::ConstantTexture<Rgb>>(Rgb(1.0f));
    primitive.where = somewhere();
    const auto light = lxs::make_area_light(primitive, lxs::Matrix());
    lxs::EmissionSample sample;
    light->sample_emission({0.3f, 0.4f, 0.5f, 0.6f}, sample);
}

template <class T>
void use(const std::shared_ptr<const lxs::Texture<T>>& texture) {
    for (const float at : {0.25f, -1e6f})
        texture->evaluate(texture_point(at));
    texture->constant();
    texture->mapped_slope(texture_point(0.25f));
}

void use(const std::shared_ptr<const lxs::Material>& material) {
    material->facts();
    lxs::ShadingPoint point;
    point.texture = texture_point(0.25f);
    point.ng = point.ns = Vec3(0, 0, 1);
    point.dpdu = Vec3(1, 0, 0);
    point.dpdv = Vec3(0, 1, 0);
    material->bend(point);
    std::pmr::monotonic_buffer_resource memory;
    const lxs::Bsdf* bsdf = material->scatter(point, memory);
    if (bsdf == nullptr) return;
    const Vec3 wo = Vec3(0.3f, 0.2f, 0.8f).normalized();
    lxs::BsdfSample sample;
    bsdf->sample(wo, {0.3f, 0.7f}, 0.4f, lxs::Transport::Radiance, lxs::kAllLobes, sample);
    for (const float z : {0.5f, -0.5f}) {
        const Vec3 wi = Vec3(-0.3f, 0.1f, z).normalized();
        bsdf->evaluate(wo, wi, lxs::Transport::Power, lxs::kAllLobes);
        bsdf->pdf(wo, wi, lxs::kAllLobes);
    }
    bsdf->albedo(wo, lxs::kAllLobes);
}

void use(const lxs::SceneMedium& named) {
    const lxs::Medium& medium = *named.medium;
    medium.transmittance(1.5f);
    medium.sample_flight(3, Rgb(1.0f), {0.3f, 0.6f});
    medium.sample_phase(Vec3(0, 0, 1), Rgb(1.0f), {0.3f, 0.6f});
}

void use_light(const ParameterSet& set) {
    lxs::LightDescription description;
    description.parameters = set;
    const lxs::SceneSphere sphere;
    SilentDiagnostics diagnostics;
    const FuzzAssets assets;
    const auto resolve = [&](const std::string& name, const lxs::SourceLocation& where) {
        return assets.resolve(name, where);
    };
    for (const auto& light : lxs::make_lights(description, sphere, resolve, diagnostics)) {
        light->power();
        lxs::EmissionSample emission;
        light->sample_emission({0.3f, 0.4f, 0.5f, 0.6f}, emission);
        lxs::DirectSample direct;
        if (light->sample_direct(Vec3(0.1f), Vec3(0, 0, 1), {0.2f, 0.9f}, direct))
            light->pdf_direct(Vec3(0.1f), Vec3(0, 0, 1), direct.wi, direct.segment_end,
                              Vec3(0, 0, 1), 0);
        light->escaped(Vec3(0, 0, 1));
    }
}

/// A scene with this option statement, and a film of 6 x 4 pixels unless it is the film's.
lxs::SceneContents contents_of(const std::string& statement, const ParameterSet& set) {
    lxs::SceneContents contents;
    contents.light_groups = {"default"};
    contents.end = somewhere();
    ParameterSet film;
    film.plugin = "fleximage";
    film.where = somewhere();
    for (const auto& [name, size] : {std::pair("xresolution", 6.0), std::pair("yresolution", 4.0)})
        film.values.push_back({"integer", name, std::vector<double>{size}, somewhere(), {}});
    contents.options["Film"].parameters = film;
    contents.options[statement].parameters = set;
    return contents;
}

/// Films that keep within this many pixels a side are made; larger ones would only take memory,
/// which they may (docs/build-on/testing.md); those beyond the film's own limit are refused by it.
constexpr double kMostPixels = 64;

ParameterSet with_small_film(ParameterSet set) {
    for (lxs::ParameterValue& value : set.values) {
        auto* numbers = std::get_if<std::vector<double>>(&value.values);
        if (numbers == nullptr || !value.name.ends_with("resolution")) continue;
        for (double& number : *numbers) {
            if (number > kMostPixels && number <= 1 << 27) number = kMostPixels;
        }
    }
    for (const char* name : {"xresolution", "yresolution"}) {
        const bool given = std::any_of(set.values.begin(), set.values.end(),
                                       [&](const auto& value) { return value.name == name; });
        if (!given)
            set.values.push_back({"integer", name, std::vector<double>{8}, somewhere(), {}});
    }
    return set;
}

void use_option(const std::string& statement, const ParameterSet& set) {
    const lxs::SceneContents contents =
        contents_of(statement, statement == "Film" ? with_small_film(set) : set);
    SilentDiagnostics diagnostics;
    if (statement == "Sampler") {
        const auto sampler = lxs::make_sampler(contents, 1, diagnostics, true);
        sampler->camera_sample(3, 1, 2);
        return;
    }
    const auto film = lxs::make_film(contents, diagnostics);
    const auto camera = lxs::make_camera(contents, *film, diagnostics);
    camera->generate({}, camera->shutter_open());
    film->image();
}

template <class Product>
void add(const std::map<std::string, lxs::Factory<Product>>& factories,
         std::vector<PluginUse>& all) {
    for (const auto& entry : factories) {
        const lxs::Factory<Product>& factory = entry.second;
        all.push_back({entry.first, factory.parameters, [&factory](const ParameterSet& set) {
                           SilentDiagnostics diagnostics;
                           const lxs::ParameterReader reader(set, factory.parameters, diagnostics);
                           use(factory.create(reader, FuzzAssets(), lxs::Matrix()));
                       }});
    }
}

}  // namespace

std::vector<PluginUse> plugin_uses() {
    std::vector<PluginUse> all;
    const lxs::Registry& known = registry();
    add(known.shapes, all);
    add(known.materials, all);
    add(known.media, all);
    add(known.float_textures, all);
    add(known.color_textures, all);
    add(known.fresnel_textures, all);
    for (const lxs::LightPlugin& light : lxs::light_plugins())
        all.push_back({light.name, light.parameters, use_light});
    for (const std::string statement : {"Camera", "Film", "PixelFilter", "Sampler"}) {
        for (const std::string& name : lxs::known_plugin_names().at(statement)) {
            all.push_back({name, lxs::option_parameters(statement, name),
                           [statement](const ParameterSet& set) { use_option(statement, set); }});
        }
    }
    return all;
}

}  // namespace fuzz
