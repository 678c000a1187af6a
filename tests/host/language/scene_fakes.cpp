// Fakes for tests of the scene reader.
#include "scene_fakes.h"

#include "lxs/scene/constant_texture.h"

namespace lxs::test {
namespace {

using Type = ParameterType;

ParameterDeclaration declare(std::string_view name, Type type, bool array = false) {
    ParameterDeclaration declaration;
    declaration.name = name;
    declaration.type = type;
    declaration.array = array;
    return declaration;
}

Geometry fake_sphere(const ParameterReader& parameters, const AssetContext&,
                     const Matrix& to_world) {
    Sphere sphere;
    sphere.radius = static_cast<float>(parameters.number("radius", 1));
    if (parameters.number("phimax", 360) == 0)
        throw EmptyShape(parameters.where("phimax"), "\"phimax\" is 0");
    return Quadric{sphere, to_world};
}

Geometry fake_mesh(const ParameterReader& parameters, const AssetContext&, const Matrix& to_world) {
    TriangleMesh mesh;
    const std::span<const double> p = parameters.numbers("P");
    for (std::size_t i = 0; i + 2 < p.size(); i += 3) {
        const Imath::V3d point(p[i], p[i + 1], p[i + 2]);
        mesh.positions.emplace_back(point * to_world);
    }
    for (const double index : parameters.numbers("indices")) {
        mesh.indices.push_back(static_cast<std::uint32_t>(index));
    }
    return mesh;
}

std::shared_ptr<const Material> fake_matte(const ParameterReader& parameters,
                                           const AssetContext& assets, const Matrix&) {
    Rgb kd = parameters.color("Kd", Rgb(0.9f));
    if (const auto name = parameters.texture_name("Kd")) {
        if (const auto texture = assets.color_texture(*name, parameters.where("Kd")))
            kd = texture->evaluate({});
    }
    return std::make_shared<FakeMaterial>(parameters.plugin(), kd);
}

std::shared_ptr<const Material> fake_mix(const ParameterReader& parameters,
                                         const AssetContext& assets, const Matrix&) {
    const auto part = assets.material(parameters.string("namedmaterial1", ""),
                                      parameters.where("namedmaterial1"));
    const auto& fake_part = dynamic_cast<const FakeMaterial&>(*part);
    return std::make_shared<FakeMaterial>("mix of " + fake_part.plugin(), fake_part.kd());
}

std::shared_ptr<Medium> fake_clear(const ParameterReader& parameters, const AssetContext&,
                                   const Matrix&) {
    return std::make_shared<Medium>(parameters.color("absorption", Rgb(0.0f)),
                                    static_cast<float>(parameters.number("fresnel", 1.5)));
}

/// A factory that makes the same product whatever the parameters.
template <class Product>
Factory<Product> fixed(const Product& product) {
    return {{}, [product](const ParameterReader&, const AssetContext&, const Matrix&) {
                return product;
            }};
}

template <class Product>
void accept_all(std::map<std::string, Factory<Product>>& registered, const std::string& statement,
                const Product& product) {
    for (const std::string& name : known_plugin_names().at(statement)) {
        registered[name] = fixed(product);
    }
}

}  // namespace

void CollectingDiagnostics::warning(const SourceLocation& where, const std::string& message) {
    messages.push_back(first_line(format_message(where, "warning", message)));
}

void CollectingDiagnostics::unknown_parameter(const SourceLocation& where,
                                              const std::string& message) {
    warning(where, message);
}

void LenientDiagnostics::error(const InputError& error) {
    messages.push_back(first_line(error.what()));
}

Registry fake_registry() {
    Registry registry;
    registry.shapes["sphere"] = {{declare("radius", Type::Float), declare("phimax", Type::Float)},
                                 fake_sphere};
    registry.shapes["trianglemesh"] = {
        {declare("P", Type::Point, true), declare("indices", Type::Integer, true)}, fake_mesh};
    registry.materials["matte"] = {{declare("Kd", Type::ColorTexture)}, fake_matte};
    registry.materials["mix"] = {
        {declare("namedmaterial1", Type::String), declare("namedmaterial2", Type::String)},
        fake_mix};
    registry.media["clear"] = {
        {declare("fresnel", Type::FresnelTexture), declare("absorption", Type::Color)}, fake_clear};
    registry.float_textures["constant"] = {
        {declare("value", Type::Float)},
        [](const ParameterReader& parameters, const AssetContext&, const Matrix&) {
            const auto value = static_cast<float>(parameters.number("value", 1));
            return std::make_shared<ConstantTexture<float>>(value);
        }};
    registry.color_textures["constant"] = {
        {declare("value", Type::Color)},
        [](const ParameterReader& parameters, const AssetContext&, const Matrix&) {
            return std::make_shared<ConstantTexture<Rgb>>(parameters.color("value", Rgb(1.0f)));
        }};
    registry.color_textures["imagemap"] = {
        {declare("filename", Type::String)},
        [](const ParameterReader& parameters, const AssetContext& assets, const Matrix&) {
            assets.resolve(parameters.string("filename", ""), parameters.where("filename"));
            return std::make_shared<ConstantTexture<Rgb>>(Rgb(0.25f));
        }};
    return registry;
}

Registry accepting_registry() {
    Registry registry;
    accept_all<Geometry>(registry.shapes, "Shape", Quadric{Sphere{}, Matrix()});
    accept_all<std::shared_ptr<const Material>>(registry.materials, "Material",
                                                std::make_shared<FakeMaterial>("any", Rgb(0.5f)));
    accept_all<SceneMedium>(registry.media, "MakeNamedVolume",
                            SceneMedium(std::make_shared<Medium>(Rgb(0.0f), 1.0f)));
    accept_all<std::shared_ptr<const FloatTexture>>(registry.float_textures, "Texture float",
                                                    std::make_shared<ConstantTexture<float>>(1.0f));
    accept_all<std::shared_ptr<const ColorTexture>>(
        registry.color_textures, "Texture color",
        std::make_shared<ConstantTexture<Rgb>>(Rgb(1.0f)));
    accept_all<std::shared_ptr<const FresnelTexture>>(
        registry.fresnel_textures, "Texture fresnel",
        std::make_shared<ConstantTexture<FresnelValue>>(FresnelValue{}));
    return registry;
}

const FakeMaterial& fake(const Primitive& primitive) {
    return dynamic_cast<const FakeMaterial&>(*primitive.material);
}

SceneContents read_text(const std::string& text, CollectingDiagnostics& diagnostics) {
    return read_scene_text(text, "test.lxs", ".", fake_registry(), diagnostics);
}

SceneContents read_world(const std::string& world, CollectingDiagnostics& diagnostics) {
    return read_text("WorldBegin\n" + world + "\nWorldEnd\n", diagnostics);
}

SceneContents read_world(const std::string& world) {
    CollectingDiagnostics diagnostics;
    return read_world(world, diagnostics);
}

std::string error_of_text(const std::string& text) {
    CollectingDiagnostics diagnostics;
    try {
        read_text(text, diagnostics);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string error_of_world(const std::string& world) {
    return first_line(error_of_text("WorldBegin\n" + world + "\nWorldEnd\n"));
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace lxs::test
