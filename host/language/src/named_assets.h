// What a scene has named so far: textures, materials, volumes; and where its files are.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "files_ahead.h"
#include "lxs/language/arguments.h"
#include "lxs/scene/registry.h"
#include "unknown_names.h"

namespace lxs {

/// A material and its place in SceneContents::material_names.
struct IndexedMaterial {
    std::shared_ptr<const Material> material;
    std::uint32_t index = 0;
};

/// Definitions return false when the name was taken; the new meaning counts from then on. A name
/// whose texture or volume could not be made is known to have been reported, and is not taken.
class NamedAssets final : public AssetContext {
  public:
    /// Appends to `files` the path of every asset that it resolves.
    NamedAssets(AssetFinder& finder, std::vector<std::string>& files, FilesAhead& ahead,
                UnknownNames& unknown, Diagnostics& diagnostics)
        : finder_(finder),
          files_(files),
          ahead_(ahead),
          unknown_(unknown),
          diagnostics_(diagnostics) {}

    std::string resolve(const std::string& name, const SourceLocation& where) const override;
    std::shared_ptr<const FloatTexture> float_texture(const std::string& name,
                                                      const SourceLocation& where) const override;
    std::shared_ptr<const ColorTexture> color_texture(const std::string& name,
                                                      const SourceLocation& where) const override;
    std::shared_ptr<const FresnelTexture> fresnel_texture(
        const std::string& name, const SourceLocation& where) const override;
    std::any take_ahead(const std::string& plugin, const std::string& path) const override {
        return ahead_.take(plugin, path);
    }
    std::shared_ptr<const Material> material(const std::string& name,
                                             const SourceLocation& where) const override;
    /// Throw IgnoredStatement naming near names if there is no such material or volume.
    const IndexedMaterial& indexed_material(const Name& name) const;
    std::shared_ptr<const Medium> medium(const Name& name) const;

    /// A null texture could not be made, which has been reported: an older one of the name stays.
    bool define(const std::string& name, std::shared_ptr<const FloatTexture> texture) {
        return define_in(float_textures_, name, std::move(texture));
    }
    bool define(const std::string& name, std::shared_ptr<const ColorTexture> texture) {
        return define_in(color_textures_, name, std::move(texture));
    }
    bool define(const std::string& name, std::shared_ptr<const FresnelTexture> texture) {
        return define_in(fresnel_textures_, name, std::move(texture));
    }
    bool define(const std::string& name, IndexedMaterial material) {
        return materials_.insert_or_assign(name, std::move(material)).second;
    }
    /// A null one could not be made, which has been reported: the name stands for none.
    bool define(const std::string& name, std::shared_ptr<const Medium> medium) {
        const bool is_made = medium != nullptr;
        std::shared_ptr<const Medium>& entry = media_[name];
        const bool was_made = entry != nullptr;
        entry = std::move(medium);
        return !is_made || !was_made;
    }

  private:
    template <class Texture>
    using Textures = std::map<std::string, std::shared_ptr<const Texture>>;
    template <class Texture>
    static bool define_in(Textures<Texture>& textures, const std::string& name,
                          std::shared_ptr<const Texture> texture) {
        std::shared_ptr<const Texture>& entry = textures[name];
        if (!texture) return true;
        const bool is_new = entry == nullptr;
        entry = std::move(texture);
        return is_new;
    }
    /// The texture `name`; null, and a message, if there is none.
    template <class Texture>
    std::shared_ptr<const Texture> find_in(const Textures<Texture>& textures, const char* type,
                                           const std::string& name,
                                           const SourceLocation& where) const;
    /// "texture "NAME" is of type float, expected type color"; empty if it is of no type.
    std::string other_type(const std::string& wanted_type, const std::string& name) const;

    AssetFinder& finder_;
    std::vector<std::string>& files_;
    FilesAhead& ahead_;
    UnknownNames& unknown_;
    Diagnostics& diagnostics_;
    Textures<FloatTexture> float_textures_;
    Textures<ColorTexture> color_textures_;
    Textures<FresnelTexture> fresnel_textures_;
    std::map<std::string, IndexedMaterial> materials_;
    std::map<std::string, std::shared_ptr<const Medium>> media_;
};

}  // namespace lxs
