// Makes shapes, materials, volumes and textures from their statements, by name.
#pragma once

#include <optional>

#include "lxs/scene/registry.h"

namespace lxs {

/// As LuxRender does, a plugin of an unknown name, or one that can't be made (a file is missing, a
/// value makes no sense), is reported as Diagnostics::fallback() and left out: no shape, a default
/// matte in place of the material, no texture, no volume.
class PluginFactory {
  public:
    PluginFactory(const Registry& registry, const AssetContext& assets, Diagnostics& diagnostics)
        : registry_(registry), assets_(assets), diagnostics_(diagnostics) {}

    /// Nothing for a shape that has no extent or can't be made.
    std::optional<Geometry> shape(const ParameterSet& set, const Matrix& to_world) const;
    std::shared_ptr<const Material> material(const ParameterSet& set, const Matrix& to_world) const;
    std::optional<SceneMedium> medium(const ParameterSet& set, const Matrix& to_world) const;
    /// Null for a texture that can't be made.
    std::shared_ptr<const FloatTexture> float_texture(const ParameterSet& set,
                                                      const Matrix& to_world) const;
    std::shared_ptr<const ColorTexture> color_texture(const ParameterSet& set,
                                                      const Matrix& to_world) const;
    std::shared_ptr<const FresnelTexture> fresnel_texture(const ParameterSet& set,
                                                          const Matrix& to_world) const;
    /// None is rendered.
    void volume_region(const ParameterSet& set) const;

  private:
    /// What a kind of plugin is called in messages and in known_plugin_names().
    struct Kind {
        const char* noun;
        const char* statement;
        const char* instead;  ///< what is used where it can't be made
        const char* state = "not rendered yet";
    };
    template <class Product>
    std::optional<Product> make(const std::map<std::string, Factory<Product>>& registered,
                                const Kind& kind, const ParameterSet& set,
                                const Matrix& to_world) const;
    template <class Texture>
    std::shared_ptr<const Texture> texture(
        const std::map<std::string, Factory<std::shared_ptr<const Texture>>>& registered,
        const char* noun, const char* statement, const ParameterSet& set,
        const Matrix& to_world) const;
    /// Reports a name that the registry lacks, with the `rendered` ones among those that are known.
    void report_missing(const Kind& kind, const ParameterSet& set,
                        const std::vector<std::string>& rendered) const;

    const Registry& registry_;
    const AssetContext& assets_;
    Diagnostics& diagnostics_;
};

}  // namespace lxs
