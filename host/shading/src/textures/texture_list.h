// The numbered inputs tex1, tex2, ... of a texture.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "texture_parameters.h"

namespace lxs::shading {

template <class T>
using TextureList = std::vector<std::shared_ptr<const Texture<T>>>;

template <class T>
bool all_constant(const TextureList<T>& list) {
    return std::all_of(list.begin(), list.end(), [](const auto& t) { return t->constant(); });
}
/// Texture::cell_size() of all of them.
template <class T>
float smallest_cell(const TextureList<T>& list) {
    float smallest = 0;
    for (const auto& texture : list)
        smallest = smaller_cell(smallest, texture->cell_size());
    return smallest;
}

template <class T>
bool any_reads_image(const TextureList<T>& list) {
    return std::any_of(list.begin(), list.end(), [](const auto& t) { return t->reads_image(); });
}

inline constexpr std::size_t kLongestTextureList = 32;

/// "tex1", "tex2", ...; `number` from 1 to kLongestTextureList.
std::string_view list_name(std::size_t number);

template <class T>
std::vector<ParameterDeclaration> texture_list_parameters(std::string_view doc) {
    std::vector<ParameterDeclaration> all;
    for (std::size_t i = 1; i <= kLongestTextureList; ++i)
        all.push_back({list_name(i), TextureKind<T>::kParameter, TextureKind<T>::kBlack, doc});
    return all;
}

/// The numbers of an array parameter, which must be given and of a length that fits a list.
std::vector<float> read_list(const ParameterReader& reader, std::string_view name);

/// tex1 to tex`count`. Fails at `counted_by` if one of them is missing.
template <class T>
TextureList<T> read_texture_list(const ParameterReader& reader, const AssetContext& assets,
                                 std::string_view counted_by, std::size_t count) {
    TextureList<T> list;
    for (std::size_t i = 1; i <= count; ++i) {
        if (!reader.given(list_name(i))) {
            reader.fail(counted_by, reader.plugin() + ": \"" + std::string(counted_by) + "\" has " +
                                        std::to_string(count) + " values, but \"" +
                                        std::string(list_name(i)) + "\" is missing");
        }
        list.push_back(TextureKind<T>::read(reader, assets, list_name(i), 0));
    }
    return list;
}

}  // namespace lxs::shading
