// Look-up of named textures, materials and volumes.
#include "named_assets.h"

namespace lxs {
namespace {

template <class Thing>
bool is_made(const std::shared_ptr<const Thing>& thing) {
    return thing != nullptr;
}
bool is_made(const IndexedMaterial& named) {
    return named.material != nullptr;
}

/// Names that a message may propose.
template <class Map>
std::vector<std::string> names_made(const Map& map) {
    std::vector<std::string> names;
    names.reserve(map.size());
    for (const auto& [name, thing] : map) {
        if (is_made(thing)) names.push_back(name);
    }
    return names;
}

}  // namespace

std::string NamedAssets::resolve(const std::string& name, const SourceLocation& where) const {
    return files_.emplace_back(finder_.find(name, where, diagnostics_));
}

template <class Texture>
std::shared_ptr<const Texture> NamedAssets::find_in(const Textures<Texture>& textures,
                                                    const char* type, const std::string& name,
                                                    const SourceLocation& where) const {
    const auto found = textures.find(name);
    if (found != textures.end()) return found->second;
    std::string message = other_type(type, name);
    if (message.empty()) {
        message = unknown_.message(std::string(type) + " texture", name,
                                   [&] { return names_made(textures); });
    }
    diagnostics_.fallback(where, message, "the parameter's default is used");
    return nullptr;
}

std::shared_ptr<const FloatTexture> NamedAssets::float_texture(const std::string& name,
                                                               const SourceLocation& where) const {
    return find_in(float_textures_, "float", name, where);
}

std::shared_ptr<const ColorTexture> NamedAssets::color_texture(const std::string& name,
                                                               const SourceLocation& where) const {
    return find_in(color_textures_, "color", name, where);
}

std::shared_ptr<const FresnelTexture> NamedAssets::fresnel_texture(
    const std::string& name, const SourceLocation& where) const {
    return find_in(fresnel_textures_, "fresnel", name, where);
}

std::shared_ptr<const Material> NamedAssets::material(const std::string& name,
                                                      const SourceLocation& where) const {
    return indexed_material({name, where}).material;
}

const IndexedMaterial& NamedAssets::indexed_material(const Name& name) const {
    const auto found = materials_.find(name.text);
    if (found != materials_.end()) return found->second;
    throw IgnoredStatement(name.where, unknown_.message("named material", name.text,
                                                        [this] { return names_made(materials_); }));
}

std::shared_ptr<const Medium> NamedAssets::medium(const Name& name) const {
    const auto found = media_.find(name.text);
    if (found != media_.end()) return found->second;
    throw IgnoredStatement(name.where, unknown_.message("named volume", name.text,
                                                        [this] { return names_made(media_); }));
}

std::string NamedAssets::other_type(const std::string& wanted_type, const std::string& name) const {
    std::string found_type;
    if (float_textures_.count(name) > 0) found_type = "float";
    if (color_textures_.count(name) > 0) found_type = "color";
    if (fresnel_textures_.count(name) > 0) found_type = "fresnel";
    if (found_type.empty()) return {};
    return "texture " + in_quotes(name) + " is of type " + found_type + ", expected type " +
           wanted_type;
}

}  // namespace lxs
