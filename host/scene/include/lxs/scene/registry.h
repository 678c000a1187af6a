// Plugins that the host renders, by category: name, declared parameters, factory.
// Each category's implementation folder fills its part (register_shapes, register_textures, ...).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lxs/scene/geometry.h"
#include "lxs/scene/material.h"
#include "lxs/scene/scene_medium.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// Resolves asset names and textures for factories.
class AssetContext {
  public:
    virtual ~AssetContext() = default;
    /// Path of the asset `name` (against the main scene's folder, then the including file's);
    /// throws InputError at `where` if there is no such file.
    virtual std::string resolve(const std::string& name, const SourceLocation& where) const = 0;
    /// Named textures; throw InputError at `where` listing near names if unknown or of another
    /// type.
    virtual std::shared_ptr<const FloatTexture> float_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    virtual std::shared_ptr<const ColorTexture> color_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    virtual std::shared_ptr<const FresnelTexture> fresnel_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    /// Named materials (mix); throws likewise.
    virtual std::shared_ptr<const Material> material(const std::string& name,
                                                     const SourceLocation& where) const = 0;
};

/// Thrown by the factory of a shape without extent: it is skipped with a warning, as in LuxRender,
/// and the rest of the scene is rendered.
class EmptyShape : public InputError {
  public:
    EmptyShape(const SourceLocation& where, const std::string& message)
        : InputError(where, message), where_(where), message_(message) {}
    const SourceLocation& where() const { return where_; }
    const std::string& message() const { return message_; }

  private:
    SourceLocation where_;
    std::string message_;
};

template <class Product>
struct Factory {
    std::vector<ParameterDeclaration> parameters;
    std::function<Product(const ParameterReader&, const AssetContext&, const Matrix& to_world)>
        create;
};

using ShapeFactory = Factory<Geometry>;
using MaterialFactory = Factory<std::shared_ptr<const Material>>;
using MediumFactory = Factory<SceneMedium>;
using FloatTextureFactory = Factory<std::shared_ptr<const FloatTexture>>;
using ColorTextureFactory = Factory<std::shared_ptr<const ColorTexture>>;
using FresnelTextureFactory = Factory<std::shared_ptr<const FresnelTexture>>;

/// Everything the reader can build. Lights, cameras, films and filters are built after reading,
/// from SceneContents (their declarations are checked then).
struct Registry {
    std::map<std::string, ShapeFactory> shapes;
    std::map<std::string, MaterialFactory> materials;
    std::map<std::string, MediumFactory> media;
    std::map<std::string, FloatTextureFactory> float_textures;
    std::map<std::string, ColorTextureFactory> color_textures;
    std::map<std::string, FresnelTextureFactory> fresnel_textures;
};

void register_shapes(Registry& registry);   ///< host/shapes
void register_shading(Registry& registry);  ///< host/shading: textures, materials, media

}  // namespace lxs
