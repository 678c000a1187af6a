// Builds textures, materials and media as a scene file would, without a reader.
#pragma once

#include <map>
#include <memory_resource>
#include <string>
#include <vector>

#include "lxs/scene/registry.h"

namespace lxs {

/// Keeps warnings instead of printing them.
class CollectedDiagnostics final : public Diagnostics {
  public:
    void warning(const SourceLocation& where, const std::string& message) override {
        warnings.push_back(message);
        lines.push_back(where.line);
    }
    void unknown_parameter(const SourceLocation&, const std::string& message) override {
        unknown.push_back(message);
    }

    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override {
        if (!lenient) return Diagnostics::fallback(where, message, instead);
        warning(where, message + "; " + instead);
    }

    bool lenient = false;  ///< goes on where LuxRender does
    std::vector<std::string> warnings, unknown;
    std::vector<std::uint32_t> lines;  ///< of each warning
};

/// One parameter as a scene file writes it; stands in line 7 of no file.
ParameterValue number(const std::string& name, double value);
ParameterValue numbers(const std::string& name, std::vector<double> values);
ParameterValue vector(const std::string& name, const Vec3& value);
ParameterValue integer(const std::string& name, std::int64_t value);
ParameterValue color(const std::string& name, const Rgb& value);
ParameterValue colors(const std::string& name, std::vector<double> channels);
ParameterValue text(const std::string& name, const std::string& value);
ParameterValue flag(const std::string& name, bool value);
ParameterValue texture(const std::string& name, const std::string& value);

/// A scene's named things and the registry that makes them.
class ShadingFixture : public AssetContext {
  public:
    ShadingFixture() { register_shading(registry); }

    std::shared_ptr<const Material> make_material(const std::string& plugin,
                                                  std::vector<ParameterValue> values = {});
    std::shared_ptr<const Medium> make_medium(const std::string& plugin,
                                              std::vector<ParameterValue> values = {});
    SceneMedium make_scene_medium(const std::string& plugin,
                                  std::vector<ParameterValue> values = {});
    std::shared_ptr<const FloatTexture> make_float(const std::string& plugin,
                                                   std::vector<ParameterValue> values = {},
                                                   const Matrix& to_world = {});
    std::shared_ptr<const ColorTexture> make_color(const std::string& plugin,
                                                   std::vector<ParameterValue> values = {},
                                                   const Matrix& to_world = {});
    std::shared_ptr<const FresnelTexture> make_fresnel(const std::string& plugin,
                                                       std::vector<ParameterValue> values = {});

    std::string resolve(const std::string& name, const SourceLocation&) const override {
        return name;
    }
    std::shared_ptr<const FloatTexture> float_texture(const std::string& name,
                                                      const SourceLocation&) const override {
        return floats.at(name);
    }
    std::shared_ptr<const ColorTexture> color_texture(const std::string& name,
                                                      const SourceLocation&) const override {
        return colors.at(name);
    }
    std::shared_ptr<const FresnelTexture> fresnel_texture(const std::string& name,
                                                          const SourceLocation&) const override {
        return fresnels.at(name);
    }
    std::shared_ptr<const Material> material(const std::string& name,
                                             const SourceLocation&) const override {
        return materials.at(name);
    }

    Registry registry;
    CollectedDiagnostics diagnostics;
    std::map<std::string, std::shared_ptr<const FloatTexture>> floats;
    std::map<std::string, std::shared_ptr<const ColorTexture>> colors;
    std::map<std::string, std::shared_ptr<const FresnelTexture>> fresnels;
    std::map<std::string, std::shared_ptr<const Material>> materials;

  private:
    template <class Plugins>
    auto make(const Plugins& plugins, const std::string& plugin, std::vector<ParameterValue> values,
              const Matrix& to_world = {});
};

/// A surface point with geometric normal `ng` and shading normal `ns`, grain along `dpdu`.
ShadingPoint shading_point(const Vec3& ng = {0, 0, 1}, const Vec3& ns = {0, 0, 1},
                           const Vec3& dpdu = {1, 0, 0});

/// Memory for Bsdfs that a test keeps.
class BsdfMemory {
  public:
    const Bsdf* scatter(const Material& material, const ShadingPoint& point) {
        return material.scatter(point, memory_);
    }

  private:
    std::pmr::monotonic_buffer_resource memory_;
};

}  // namespace lxs
