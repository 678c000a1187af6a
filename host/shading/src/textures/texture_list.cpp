// The numbered inputs tex1, tex2, ... of a texture.
#include "texture_list.h"

#include <array>
#include <string>

namespace lxs::shading {

std::string_view list_name(std::size_t number) {
    static const auto names = [] {
        std::array<std::string, kLongestTextureList> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = "tex" + std::to_string(i + 1);
        return all;
    }();
    return names.at(number - 1);
}

std::vector<float> read_list(const ParameterReader& reader, std::string_view name) {
    const auto numbers = reader.numbers(name);
    if (numbers.empty() || numbers.size() > kLongestTextureList) {
        reader.fail(name, reader.plugin() + ": \"" + std::string(name) + "\" needs 1 to " +
                              std::to_string(kLongestTextureList) + " values");
    }
    return {numbers.begin(), numbers.end()};
}

}  // namespace lxs::shading
