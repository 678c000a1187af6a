// Factory calls for the tests of shapes.
#include "shape_fixture.h"

namespace lxs::test {
namespace {

/// Its value is u.
class Ramp final : public FloatTexture {
  public:
    float evaluate(const TexturePoint& point) const override { return point.uv.x; }
};

/// File names are paths already; every float texture is the ramp.
class PlainAssets : public AssetContext {
  public:
    std::string resolve(const std::string& name, const SourceLocation&) const override {
        return name;
    }
    std::shared_ptr<const FloatTexture> float_texture(const std::string&,
                                                      const SourceLocation&) const override {
        return std::make_shared<Ramp>();
    }
    std::shared_ptr<const ColorTexture> color_texture(const std::string&,
                                                      const SourceLocation&) const override {
        return nullptr;
    }
    std::shared_ptr<const FresnelTexture> fresnel_texture(const std::string&,
                                                          const SourceLocation&) const override {
        return nullptr;
    }
    std::shared_ptr<const Material> material(const std::string&,
                                             const SourceLocation&) const override {
        return nullptr;
    }
};

}  // namespace

ParameterValue numbers(const std::string& type, const std::string& name,
                       std::vector<double> values) {
    return {type, name, std::move(values), {}, {}};
}
ParameterValue text(const std::string& name, const std::string& value) {
    return {"string", name, std::vector<std::string>{value}, {}, {}};
}
ParameterValue flag(const std::string& name, bool value) {
    return {"bool", name, std::vector<bool>{value}, {}, {}};
}

void RecordedDiagnostics::warning(const SourceLocation& where, const std::string& message) {
    warnings.push_back(message);
    lines.push_back(where.line);
}
void RecordedDiagnostics::unknown_parameter(const SourceLocation& where,
                                            const std::string& message) {
    warning(where, message);
}

void RecordedDiagnostics::fallback(const SourceLocation& where, const std::string& message,
                                   const std::string& instead) {
    if (!lenient) return Diagnostics::fallback(where, message, instead);
    warning(where, message + "; " + instead);
}

Geometry make_shape(const std::string& plugin, std::vector<ParameterValue> values,
                    RecordedDiagnostics& diagnostics, const Matrix& to_world) {
    Registry registry;
    register_shapes(registry);
    const auto file = std::make_shared<const SourceFile>(SourceFile{"scene.lxs", {}, {}, 0});
    ParameterSet set{plugin, {file, 1, 1}, std::move(values)};
    for (std::size_t i = 0; i < set.values.size(); ++i)
        set.values[i].where = {file, static_cast<std::uint32_t>(i) + 2, 1};
    const ShapeFactory& factory = registry.shapes.at(plugin);
    const ParameterReader reader(set, factory.parameters, diagnostics);
    return factory.create(reader, PlainAssets(), to_world);
}

TriangleMesh make_mesh(const std::string& plugin, std::vector<ParameterValue> values,
                       const Matrix& to_world) {
    RecordedDiagnostics diagnostics;
    return std::get<TriangleMesh>(make_shape(plugin, std::move(values), diagnostics, to_world));
}

std::string error_of(const std::string& plugin, std::vector<ParameterValue> values,
                     const Matrix& to_world) {
    try {
        RecordedDiagnostics diagnostics;
        make_shape(plugin, std::move(values), diagnostics, to_world);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace lxs::test
