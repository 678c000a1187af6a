// Plugins that the host renders, by category: name, declared parameters, factory.
// Each category's implementation folder fills its part (register_shapes, register_textures, ...).
#pragma once

#include <any>
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
    /// Named textures; null where there is none or it is of another type, which has been reported
    /// at `where`: the parameter that names it then keeps its default.
    virtual std::shared_ptr<const FloatTexture> float_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    virtual std::shared_ptr<const ColorTexture> color_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    virtual std::shared_ptr<const FresnelTexture> fresnel_texture(
        const std::string& name, const SourceLocation& where) const = 0;
    /// What the factory of `plugin` made of the file by `read_file`, if it was read ahead and has
    /// not been taken yet; else empty.
    virtual std::any take_ahead(const std::string& /*plugin*/, const std::string& /*path*/) const {
        return {};
    }
    /// Named materials (mix); throws InputError at `where` if there is none.
    virtual std::shared_ptr<const Material> material(const std::string& name,
                                                     const SourceLocation& where) const = 0;
};

/// Thrown by the factory of a shape without extent: it is skipped with a warning, as in LuxRender,
/// and the rest of the scene is rendered.
class EmptyShape : public InputError {
    using InputError::InputError;
};

/// Thrown where going on could only find more of the same, without bound: no memory, more files or
/// instances than any scene has. After any other InputError reading goes on.
class EndOfReading : public InputError {
    using InputError::InputError;
};

template <class Product>
struct Factory {
    std::vector<ParameterDeclaration> parameters;
    std::function<Product(const ParameterReader&, const AssetContext&, const Matrix& to_world)>
        create;
    /// Reads the file that the parameter "filename" names, as `create` does, from any thread and
    /// without a message: a scene's files are read several at a time. What it throws is passed
    /// over, since `create` then reads again. Null: there is nothing to read ahead.
    std::function<std::any(const std::string& path)> read_file = {};
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
