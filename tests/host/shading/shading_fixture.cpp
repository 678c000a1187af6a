// Builds textures, materials and media as a scene file would, without a reader.
#include "shading_fixture.h"

namespace lxs {
namespace {

template <class Values>
ParameterValue parameter(const std::string& type, const std::string& name, Values values) {
    ParameterValue parameter;
    parameter.type = type;
    parameter.name = name;
    parameter.values = std::move(values);
    parameter.where.line = 7;
    return parameter;
}

}  // namespace

ParameterValue number(const std::string& name, double value) {
    return parameter("float", name, std::vector<double>{value});
}
ParameterValue numbers(const std::string& name, std::vector<double> values) {
    return parameter("float", name, std::move(values));
}
ParameterValue vector(const std::string& name, const Vec3& value) {
    return parameter("vector", name, std::vector<double>{value.x, value.y, value.z});
}
ParameterValue integer(const std::string& name, std::int64_t value) {
    return parameter("integer", name, std::vector<double>{static_cast<double>(value)});
}
ParameterValue color(const std::string& name, const Rgb& value) {
    return parameter("color", name, std::vector<double>{value.x, value.y, value.z});
}
ParameterValue colors(const std::string& name, std::vector<double> channels) {
    return parameter("color", name, std::move(channels));
}
ParameterValue text(const std::string& name, const std::string& value) {
    return parameter("string", name, std::vector<std::string>{value});
}
ParameterValue flag(const std::string& name, bool value) {
    return parameter("bool", name, std::vector<bool>{value});
}
ParameterValue texture(const std::string& name, const std::string& value) {
    return parameter("texture", name, std::vector<std::string>{value});
}

template <class Plugins>
auto ShadingFixture::make(const Plugins& plugins, const std::string& plugin,
                          std::vector<ParameterValue> values, const Matrix& to_world) {
    const auto& factory = plugins.at(plugin);
    ParameterSet set;
    set.plugin = plugin;
    set.values = std::move(values);
    const ParameterReader reader(set, factory.parameters, diagnostics);
    return factory.create(reader, *this, to_world);
}

std::shared_ptr<const Material> ShadingFixture::make_material(const std::string& plugin,
                                                              std::vector<ParameterValue> values) {
    return make(registry.materials, plugin, std::move(values));
}
std::shared_ptr<const Medium> ShadingFixture::make_medium(const std::string& plugin,
                                                          std::vector<ParameterValue> values) {
    return make_scene_medium(plugin, std::move(values)).medium;
}
SceneMedium ShadingFixture::make_scene_medium(const std::string& plugin,
                                              std::vector<ParameterValue> values) {
    return make(registry.media, plugin, std::move(values));
}
std::shared_ptr<const FloatTexture> ShadingFixture::make_float(const std::string& plugin,
                                                               std::vector<ParameterValue> values,
                                                               const Matrix& to_world) {
    return make(registry.float_textures, plugin, std::move(values), to_world);
}
std::shared_ptr<const ColorTexture> ShadingFixture::make_color(const std::string& plugin,
                                                               std::vector<ParameterValue> values,
                                                               const Matrix& to_world) {
    return make(registry.color_textures, plugin, std::move(values), to_world);
}
std::shared_ptr<const FresnelTexture> ShadingFixture::make_fresnel(
    const std::string& plugin, std::vector<ParameterValue> values) {
    return make(registry.fresnel_textures, plugin, std::move(values));
}

ShadingPoint shading_point(const Vec3& ng, const Vec3& ns, const Vec3& dpdu) {
    ShadingPoint point;
    point.ng = ng.normalized();
    point.ns = ns.normalized();
    point.dpdu = dpdu;
    point.texture.n = point.ns;
    return point;
}

}  // namespace lxs
