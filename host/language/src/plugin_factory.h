// Makes shapes, materials, volumes and textures from their statements, by name.
#pragma once

#include <optional>

#include "lxs/scene/registry.h"

namespace lxs {

/// A name that LuxRender knows and the registry doesn't is warned of, and a stand-in is made; any
/// other name is an InputError that lists the known ones. Bad parameters throw InputError.
class PluginFactory {
  public:
    PluginFactory(const Registry& registry, const AssetContext& assets, Diagnostics& diagnostics)
        : registry_(registry), assets_(assets), diagnostics_(diagnostics) {}

    /// Nothing for a shape that isn't rendered or has no extent.
    std::optional<Geometry> shape(const ParameterSet& set, const Matrix& to_world) const;
    std::shared_ptr<const Material> material(const ParameterSet& set, const Matrix& to_world) const;
    SceneMedium medium(const ParameterSet& set, const Matrix& to_world) const;
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
        const char* stand_in;  ///< what is used for names that are known but not rendered
        const char* state = "not rendered yet";
    };
    template <class Product>
    std::optional<Product> make(const std::map<std::string, Factory<Product>>& registered,
                                const Kind& kind, const ParameterSet& set,
                                const Matrix& to_world) const;
    /// Warns of a name that LuxRender knows; throws for any other, with the `rendered` ones among
    /// those that are known.
    void report_missing(const Kind& kind, const ParameterSet& set,
                        const std::vector<std::string>& rendered) const;

    const Registry& registry_;
    const AssetContext& assets_;
    Diagnostics& diagnostics_;
};

}  // namespace lxs
